#include "world/scene_hash.h"

#include <gtest/gtest.h>

#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

std::uint64_t hash_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return scene_hash(parse_scene(text, "folder", overrides), {});
}

TEST(SceneHash, ChangesWithEverySetting) {
  const std::string text =
      std::string(testing::kPlainScene) +
      "[[camera]]\nname = \"a\"\nposition_m = [0, 0, 1]\n[maps]\nbend = { file = \"b\" }\n"
      "[wind]\nspeed_m_per_s = 3\n[[wind.gust]]\n[[wind.tornado]]\n[[wind.breeze]]\n"
      "[[mover]]\nname = \"m\"\npath_m = [[0, 0], [1, 1]]\n";
  const std::uint64_t hash = hash_of(text);
  EXPECT_EQ(hash, hash_of(text));
  EXPECT_EQ(hash, hash_of("# a comment\n" + text));
  for (const char* change : {"seed=2",
                             "tile_m=8",
                             "ground.size_m=[40, 21]",
                             "ground.soil_color=#000000",
                             "species.0.name=oat",
                             "species.0.density=999",
                             "species.0.height_m=0.33",
                             "species.0.height_spread=0.1",
                             "species.0.width_mm=3",
                             "species.0.width_spread=0.1",
                             "species.0.tilt_deg=1",
                             "species.0.lean_deg=1",
                             "species.0.curvature_deg=1",
                             "species.0.curvature_spread=0.1",
                             "species.0.mass_g=1",
                             "species.0.stiffness=1",
                             "species.0.stiffness_spread=0.1",
                             "species.0.clump_m=1",
                             "species.0.clump_strength=0.1",
                             "species.0.clump_spray_deg=1",
                             "species.0.root_color=#000000",
                             "species.0.tip_color=#000000",
                             "species.0.dry_color=#000000",
                             "species.0.transmission=#000000",
                             "species.0.dry_share=0.9",
                             "species.0.dry_spread=0.9",
                             "species.0.hue_spread=0.9",
                             "species.0.specular=0.9",
                             "maps.bend.max=2",
                             "maps.bend.range=[0, 1]",
                             "maps.bend.channel=R",
                             "maps.bend.nodata=0",
                             "maps.bend.spacing_m=2",
                             "maps.bend.repeat=true",
                             "camera.a.name=b",
                             "camera.a.yaw_deg=1",
                             "camera.a.pitch_deg=1",
                             "camera.a.fov_deg=50",
                             "camera.a.position_m=[0, 1, 1]",
                             "camera.a.position_m=[0, 0, 2]",
                             "camera.a.position_m=[0, 0, \"+1\"]",
                             "sun.azimuth_deg=1",
                             "sun.elevation_deg=1",
                             "sun.color=#000000",
                             "sun.intensity=1",
                             "sky.intensity=0.5",
                             "sky.haze_per_m=0.5",
                             "lod.quality=high",
                             "lod.blade_distance_m=50",
                             "species.0.damping_ratio=0.3",
                             "species.0.drag_coefficient=0.3",
                             "wind.speed_m_per_s=4",
                             "wind.heading_deg=4",
                             "wind.turbulence=0.5",
                             "wind.gust=[]",
                             "wind.gust.0.position_m=[0, 1]",
                             "wind.gust.0.heading_deg=1",
                             "wind.gust.0.travel_m_per_s=1",
                             "wind.gust.0.strength_m_per_s=1",
                             "wind.gust.0.width_m=1",
                             "wind.gust.0.depth_m=1",
                             "wind.gust.0.way_m=1",
                             "wind.gust.0.start_s=1",
                             "wind.tornado.0.position_m=[0, 1]",
                             "wind.tornado.0.heading_deg=1",
                             "wind.tornado.0.travel_m_per_s=1",
                             "wind.tornado.0.strength_m_per_s=1",
                             "wind.tornado.0.radius_m=1",
                             "wind.tornado.0.reach_m=9",
                             "wind.tornado.0.inflow=1",
                             "wind.tornado.0.wander_m=1",
                             "wind.tornado.0.wander_s=1",
                             "wind.tornado.0.start_s=1",
                             "wind.tornado.0.duration_s=1",
                             "wind.tornado.0.seed=2",
                             "wind.breeze.0.position_m=[0, 1]",
                             "wind.breeze.0.heading_deg=1",
                             "wind.breeze.0.strength_m_per_s=1",
                             "wind.breeze.0.period_s=1",
                             "wind.breeze.0.wavelength_m=1",
                             "wind.breeze.0.radius_m=1",
                             "treading.spacing_m=0.2",
                             "treading.recovery_s=1",
                             "treading.most_tilt_deg=50",
                             "treading.wear_passes=1",
                             "treading.worn_field=1",
                             "treading.load_slowing=2",
                             "treading.worn_slowing=1",
                             "treading.field_scale=1",
                             "mover.m.name=n",
                             "mover.m.kind=cart",
                             "mover.m.radius_m=1",
                             "mover.m.speed_m_per_s=2",
                             "mover.m.start_s=1",
                             "mover.m.loops=true",
                             "mover.m.path_m=[[0, 0], [1, 2]]"}) {
    EXPECT_NE(hash, hash_of(text, {change})) << change;
  }
}

TEST(SceneHash, KnowsMapsByContentNotByName) {
  const TemporaryFolder folder;
  const auto open = [&](const char* name, const char* file, float somewhere) {
    std::filesystem::create_directories(folder / name);
    testing::write_raster(folder / name / file, 9, 9, 1.0, std::nullopt,
                          [&](int column, int row) { return column == 4 && row == 4 ? somewhere : 0.5f; });
    const std::string text =
        "version = 1\n[[species]]\nname = \"a\"\ndensity = { file = \"" + std::string(file) + "\" }\n";
    return testing::open_scene(folder / name, text).scene_hash();
  };
  const std::uint64_t hash = open("here", "a.tif", 0.25f);
  EXPECT_EQ(hash, open("there", "a.tif", 0.25f));
  EXPECT_EQ(hash, open("renamed", "b.tif", 0.25f));
  EXPECT_NE(hash, open("changed", "a.tif", 0.26f));
}

TEST(SceneHash, KnowsTheSeedInUse) {
  const Scene scene = parse_scene(testing::kPlainScene, "folder", {});
  WorldOptions other;
  other.seed = 5;
  EXPECT_NE(World(scene, {}).scene_hash(), World(scene, other).scene_hash());
  EXPECT_EQ(World(scene, other).meadow().seed, 5u);
}

}  // namespace
}  // namespace prairie
