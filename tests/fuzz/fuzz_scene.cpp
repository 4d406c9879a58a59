// Fuzzes the reader of scene files: the bytes before the first NUL are scene.toml, those after it are
// overrides, one a line. Whatever they are, they give a scene within its limits, which is the same once it
// has been written and read, or BadInput in one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "animation/treading.h"
#include "world/scene/scene.h"
#include "world/scene/scene_hash.h"
#include "world/scene/scene_text.h"

namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

void require(bool holds) {
  if (!holds) std::abort();
}

/// What the reader accepts, those take who work with it.
void require_usable(const prairie::Scene& scene) {
  constexpr double kLateS = 1e6;
  require(scene.movers.size() <= prairie::kMaxMovers);
  require(!scene.wind || scene.wind->primitives.size() <= prairie::kMaxWindPrimitives);
  try {
    const prairie::Treading treading(scene.treading);
    for (const prairie::MoverSpec& spec : scene.movers) {
      const prairie::MoverPlace place = prairie::Mover(spec.path).place(prairie::HeightField(), kLateS);
      require(std::isfinite(place.centre_m.x) && std::isfinite(place.axes[0].x));
    }
    if (!scene.wind) return;
    for (const prairie::WindPrimitive& primitive : scene.wind->primitives) prairie::check(primitive, "");
  } catch (const prairie::BadInput&) {
    require(false);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const auto end = input.find('\0');
  const std::string_view overrides =
      end == std::string_view::npos ? std::string_view() : input.substr(end + 1);
  try {
    const prairie::Scene scene = prairie::parse_scene(input.substr(0, end), "folder", lines_of(overrides));
    require(!scene.species.empty() && scene.species.size() <= prairie::kMaxSpecies);
    for (const prairie::SpeciesSpec& spec : scene.species) {
      require(spec.uniform_density_per_m2 >= 0.0 && spec.uniform_density_per_m2 <= prairie::kMaxDensityPerM2);
      require(!spec.density || (spec.density->max >= 0.0 && spec.density->max <= prairie::kMaxDensityPerM2));
      require(spec.species.params.height_m > 0.0f && spec.species.params.clump_m > 0.0f);
    }
    require_usable(scene);
    const prairie::Scene again = prairie::parse_scene(prairie::scene_text(scene), scene.folder, {});
    require(prairie::scene_hash(again, {}) == prairie::scene_hash(scene, {}));
  } catch (const prairie::BadInput& fault) {
    require(std::string_view(fault.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
