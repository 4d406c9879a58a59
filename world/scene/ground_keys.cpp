// What the scene's file says outside of its sections, and [ground].
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

// A cell of the largest tile holds fewer blades at the largest density than an identity can count.
constexpr Bounds kTileM{0.5, 16.0};
constexpr Bounds kSizeM{0.5, 20'000.0};

void read_size_of_ground(TableReader& table, const KeyTraits& key, const Scene& so_far, Scene& scene) {
  read_value(table, key, scene.extent_m);
  if (so_far.height && table.has(key.name)) {
    table.refuse(key.name, "a size beside a height map", "one of the two: the height map gives the size");
  }
}

// The usual one is what scenes meant before there was a choice.
void hash_density_per(CanonicalText& text, const KeyTraits& key, const ContentHashes&, const Scene& scene) {
  if (scene.density_per == DensityPer::kSurface) text.add(key.hash.name, std::uint64_t{1});
}

}  // namespace

const KeyTable<Scene>& top_keys() {
  static const KeyTable<Scene> table{{
      key<&Scene::seed>({.name = "seed", .hash = {"seed"}}),
      key<&Scene::tile_m>({.name = "tile_m", .range = kTileM, .hash = {"tile_m"}}),
      {.traits = {.name = "density_per", .words = {"map", "surface"}, .hash = {"density_per"}},
       .read = read_member<Scene, &Scene::density_per>,
       .hash = hash_density_per,
       .text = member_text<Scene, &Scene::density_per>},
  }};
  return table;
}

const KeyTable<Scene>& ground_keys() {
  static const KeyTable<Scene> table{{
      {.traits = {.name = "size_m", .range = kSizeM, .hash = {"extent_m"}},
       .read = read_size_of_ground,
       .hash = hash_member<Scene, &Scene::extent_m>,
       .text = member_text<Scene, &Scene::extent_m>},
      key<&Scene::soil_color>({.name = "soil_color", .range = kShare, .hash = {"soil_color"}}),
  }};
  return table;
}

}  // namespace prairie
