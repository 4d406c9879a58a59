#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/scenes/info_formats.h"
#include "tests/world/scene_texts.h"
#include "world/world.h"

namespace prairie {
namespace {

World plain_world(const std::vector<std::string>& overrides) {
  return World(parse_scene(testing::kPlainScene, "folder", overrides), {});
}

TEST(Info, CountsTilesAndBlades) {
  const SceneReport report = describe_scene(plain_world({"species.0.density=250"}));
  EXPECT_EQ(report.tiles_east, 10);
  EXPECT_EQ(report.tiles_north, 5);
  ASSERT_EQ(report.species.size(), 1u);
  EXPECT_EQ(report.species[0].name, "fescue");
  EXPECT_NEAR(report.expected_blades, 250.0 * 40.0 * 20.0, 1e-3 * 250.0 * 40.0 * 20.0);
  EXPECT_NEAR(report.species[0].mean_per_m2, 250.0, 0.25);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Info, WarnsOfTooManyBladesAndOfNone) {
  EXPECT_EQ(describe_scene(plain_world({"species.0.density=6000"})).warnings.size(), 1u);
  EXPECT_EQ(describe_scene(plain_world({"species.0.density=0"})).warnings.size(), 1u);
}

TEST(Info, PrintsOneJsonObject) {
  const TemporaryFolder folder;
  testing::write_raster(folder / "a.tif", 11, 11, 2.0, glm::dvec2(500.0, 600.0),
                        [](int, int) { return 0.5f; });
  const World world = testing::open_scene(
      folder.path(), "version = 1\n[[species]]\nname = \"a\"\ndensity = { file = \"a.tif\" }\n");
  const auto json = nlohmann::json::parse(info_json(describe_scene(world)));
  EXPECT_EQ(json["extent_m"], (std::vector{20.0, 20.0}));
  EXPECT_EQ(json["tiles"], (std::vector{5, 5}));
  EXPECT_EQ(json["maps"][0]["file"], "a.tif");
  EXPECT_EQ(json["maps"][0]["memory_bytes"], 11 * 11 * 4);
  EXPECT_EQ(json["map_memory_bytes"], 11 * 11 * 4);
  EXPECT_EQ(json["geo_reference"]["west_m"], 500.0);
  EXPECT_EQ(json["scene_hash"].get<std::string>().size(), 16u);
  EXPECT_NEAR(json["expected_blades"].get<double>(), 500.0 * 400.0, 200.0);
  EXPECT_EQ(json["cameras"], (std::vector<std::string>{"default"}));
}

TEST(Info, PrintsTextForPeople) {
  const std::string text = info_text(describe_scene(plain_world({})));
  EXPECT_NE(text.find("extent    40.0 × 20.0 m"), std::string::npos) << text;
  EXPECT_NE(text.find("tiles     10 × 5 of 4 m"), std::string::npos) << text;
}

TEST(Info, TellsWhatMoves) {
  const World world(
      parse_scene(
          std::string(testing::kPlainScene) +
              "[wind]\nspeed_m_per_s = 6.5\n[[wind.gust]]\n[[mover]]\nname = \"boulder\"\nloops = true\n"
              "path_m = [[0, 0], [10, 0]]\n[[condition]]\n[[condition]]\n",
          "folder", {}),
      {});
  const std::string text = info_text(describe_scene(world));
  EXPECT_NE(text.find("wind      6.5 m/s towards 90°, turbulence 1, 1 gusts"), std::string::npos) << text;
  EXPECT_NE(text.find("mover     boulder: stone, 1 m/s along 20.0 m, round and round"), std::string::npos)
      << text;
  EXPECT_NE(text.find("grass     2 conditions come over it"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(info_json(describe_scene(world)));
  EXPECT_EQ(json["conditions"], 2);
  EXPECT_EQ(json["wind"]["speed_m_per_s"], 6.5);
  EXPECT_EQ(json["movers"][0]["name"], "boulder");
  EXPECT_NEAR(json["movers"][0]["length_m"].get<double>(), 20.0, 1e-3);
  const auto plain = nlohmann::json::parse(info_json(describe_scene(plain_world({}))));
  EXPECT_TRUE(plain["wind"].is_null());
}

}  // namespace
}  // namespace prairie
