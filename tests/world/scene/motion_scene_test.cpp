// Wind, treading and movers in scene files, and the motion of a species' blades.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "animation/inertial_chains.h"
#include "tests/world/scene_texts.h"
#include "world/scene_wind.h"

namespace prairie {
namespace {

using testing::expect_refused;
using testing::kPlainScene;
using testing::Refusal;
using testing::refusal_of;

Scene plain_with(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return parse_scene(std::string(kPlainScene) + more, "folder", overrides);
}

constexpr const char* kEverything = R"(damping_ratio = 0.4
drag_coefficient = 1.1
[wind]
speed_m_per_s = 6.5
heading_deg = 180
turbulence = 0.5
[[wind.gust]]
position_m = [1, 2]
heading_deg = 0
travel_m_per_s = 9
strength_m_per_s = -7
width_m = 50
depth_m = 20
way_m = 200
start_s = 3
[[wind.tornado]]
position_m = [3, 4]
heading_deg = 90
travel_m_per_s = 1
strength_m_per_s = 20
radius_m = 2
reach_m = 30
inflow = 0.5
wander_m = 6
wander_s = 7
start_s = 8
duration_s = 9
seed = 4294967295
[[wind.breeze]]
position_m = [5, 6]
heading_deg = -90
strength_m_per_s = 2
period_s = 3
wavelength_m = 10
radius_m = 40
[[wind.gust]]
[treading]
spacing_m = 0.2
recovery_s = 120
most_tilt_deg = 45
wear_passes = 10
worn_field = 0.3
load_slowing = 4
worn_slowing = 5
field_scale = 0.7
[[mover]]
name = "boulder"
path_m = [[0, 0], [5, 5]]
[[mover]]
name = "cart"
kind = "cart"
radius_m = 0.9
speed_m_per_s = 2
start_s = -4
loops = true
path_m = [[0, 0], [5.5, 5], [8, -1]]
)";

TEST(MotionScene, HasDefaults) {
  const Scene scene = plain_with("");
  EXPECT_FALSE(scene.wind);
  EXPECT_TRUE(scene.movers.empty());
  EXPECT_EQ(scene.treading.recovery_s, TreadSettings{}.recovery_s);
  EXPECT_EQ(scene.species[0].motion.damping_ratio, BladeMotionSpec{}.damping_ratio);
  const WindSpec calm = plain_with("[wind]").wind.value();
  EXPECT_EQ(calm.speed_m_per_s, 0.0);
  EXPECT_EQ(calm.heading_deg, 90.0);
  EXPECT_EQ(calm.turbulence, 1.0);
}

TEST(MotionScene, ReadsEveryKey) {
  const Scene scene = plain_with(kEverything);
  EXPECT_EQ(scene.species[0].motion.damping_ratio, 0.4);
  EXPECT_EQ(scene.species[0].motion.drag_coefficient, 1.1);

  const WindSpec& wind = scene.wind.value();
  EXPECT_EQ(wind.speed_m_per_s, 6.5);
  EXPECT_EQ(wind.heading_deg, 180.0);
  EXPECT_EQ(wind.turbulence, 0.5);
  ASSERT_EQ(wind.primitives.size(), 4u);
  const Gust& gust = std::get<Gust>(wind.primitives[0]);
  EXPECT_EQ(gust.origin_m, glm::dvec2(1.0, 2.0));
  EXPECT_DOUBLE_EQ(gust.heading_rad, 0.5 * std::numbers::pi);
  EXPECT_EQ(gust.travel_m_per_s, 9.0);
  EXPECT_EQ(gust.strength_m_per_s, -7.0);
  EXPECT_EQ(gust.width_m, 50.0);
  EXPECT_EQ(gust.depth_m, 20.0);
  EXPECT_EQ(gust.way_m, 200.0);
  EXPECT_EQ(gust.start_s, 3.0);
  EXPECT_EQ(std::get<Gust>(wind.primitives[1]).way_m, Gust{}.way_m);
  const Tornado& tornado = std::get<Tornado>(wind.primitives[2]);
  EXPECT_EQ(tornado.origin_m, glm::dvec2(3.0, 4.0));
  EXPECT_EQ(tornado.heading_rad, 0.0);
  EXPECT_EQ(tornado.travel_m_per_s, 1.0);
  EXPECT_EQ(tornado.strength_m_per_s, 20.0);
  EXPECT_EQ(tornado.radius_m, 2.0);
  EXPECT_EQ(tornado.reach_m, 30.0);
  EXPECT_EQ(tornado.inflow, 0.5);
  EXPECT_EQ(tornado.wander_m, 6.0);
  EXPECT_EQ(tornado.wander_s, 7.0);
  EXPECT_EQ(tornado.start_s, 8.0);
  EXPECT_EQ(tornado.duration_s, 9.0);
  EXPECT_EQ(tornado.seed, 4294967295u);
  const Breeze& breeze = std::get<Breeze>(wind.primitives[3]);
  EXPECT_EQ(breeze.origin_m, glm::dvec2(5.0, 6.0));
  EXPECT_DOUBLE_EQ(breeze.heading_rad, std::numbers::pi);
  EXPECT_EQ(breeze.strength_m_per_s, 2.0);
  EXPECT_EQ(breeze.period_s, 3.0);
  EXPECT_EQ(breeze.wavelength_m, 10.0);
  EXPECT_EQ(breeze.radius_m, 40.0);

  EXPECT_EQ(scene.treading.spacing_m, 0.2);
  EXPECT_EQ(scene.treading.recovery_s, 120.0);
  EXPECT_FLOAT_EQ(scene.treading.most_tilt_rad, static_cast<float>(0.25 * std::numbers::pi));
  EXPECT_EQ(scene.treading.wear_passes, 10.0f);
  EXPECT_EQ(scene.treading.worn_field, 0.3f);
  EXPECT_EQ(scene.treading.load_slowing, 4.0f);
  EXPECT_EQ(scene.treading.worn_slowing, 5.0f);
  EXPECT_EQ(scene.treading.field_scale, 0.7f);

  ASSERT_EQ(scene.movers.size(), 2u);
  EXPECT_EQ(scene.movers[0].name, "boulder");
  EXPECT_EQ(scene.movers[0].path.kind, MoverKind::kStone);
  EXPECT_EQ(scene.movers[0].path.radius_m, MoverPath{}.radius_m);
  EXPECT_FALSE(scene.movers[0].path.loops);
  const MoverPath& cart = scene.movers[1].path;
  EXPECT_EQ(cart.kind, MoverKind::kCart);
  EXPECT_EQ(cart.radius_m, 0.9);
  EXPECT_EQ(cart.speed_m_per_s, 2.0);
  EXPECT_EQ(cart.start_s, -4.0);
  EXPECT_TRUE(cart.loops);
  EXPECT_EQ(cart.path_m, (std::vector<glm::dvec2>{{0.0, 0.0}, {5.5, 5.0}, {8.0, -1.0}}));
}

TEST(MotionScene, TakesOverrides) {
  EXPECT_EQ(plain_with("", {"wind.speed_m_per_s=5"}).wind.value().speed_m_per_s, 5.0);
  EXPECT_EQ(plain_with("", {"treading.recovery_s=5"}).treading.recovery_s, 5.0);
  EXPECT_EQ(plain_with("", {"wind.file=gusty.csv"}).wind.value().file, "folder/gusty.csv");
  EXPECT_EQ(plain_with(kEverything, {"mover.boulder.radius_m=1"}).movers[0].path.radius_m, 1.0);
  EXPECT_EQ(plain_with(kEverything, {"mover.1.path_m=[[0, 0], [1, 1]]"}).movers[1].path.path_m.size(), 2u);
  EXPECT_EQ(plain_with(kEverything, {"species.fescue.drag_coefficient=0"}).species[0].motion.drag_coefficient,
            0.0);
  const Scene scene = plain_with(kEverything, {"wind.gust.1.way_m=77"});
  EXPECT_EQ(std::get<Gust>(scene.wind.value().primitives[1]).way_m, 77.0);
  const Scene all = plain_with("", {"wind.breeze=[{ period_s = 2 }]"});
  EXPECT_EQ(std::get<Breeze>(all.wind.value().primitives[0]).period_s, 2.0);
  const Fault fault = refusal_of(kPlainScene, {"wind.sped_m_per_s=5"});
  EXPECT_EQ(fault.field, "--set wind.sped_m_per_s");
  EXPECT_NE(fault.expected.find("did you mean 'speed_m_per_s'?"), std::string::npos);
}

TEST(MotionScene, MeasuredWindIsItsOwnTurbulence) {
  EXPECT_EQ(plain_with("[wind]\nfile = \"a.csv\"").wind.value().turbulence, 0.0);
  EXPECT_EQ(plain_with("[wind]\nfile = \"a.csv\"\nturbulence = 0.7").wind.value().turbulence, 0.7);
  const WindSpec wind = plain_with("[wind]\nfile = \"/b/a.csv\"\nplace_m = [3, 4]").wind.value();
  EXPECT_EQ(wind.file, "/b/a.csv");
  EXPECT_EQ(wind.place_m, glm::dvec2(3.0, 4.0));
}

TEST(MotionScene, HasItsLimits) {
  std::string winds = "[wind]\n", movers;
  for (std::size_t n = 0; n < kMaxWindPrimitives; ++n) winds += "[[wind.gust]]\n";
  EXPECT_EQ(plain_with(winds).wind.value().primitives.size(), kMaxWindPrimitives);
  EXPECT_EQ(refusal_of(kPlainScene + winds + "[[wind.breeze]]\n").field, "wind.breeze");
  for (std::size_t n = 0; n < kMaxMovers; ++n)
    movers += fmt::format("[[mover]]\nname = \"m{}\"\npath_m = [[0, 0], [1, 0]]\n", n);
  EXPECT_EQ(plain_with(movers).movers.size(), kMaxMovers);
  EXPECT_EQ(refusal_of(kPlainScene + movers + "[[mover]]\nname = \"more\"\npath_m = [[0, 0], [1, 0]]").field,
            "mover");
  std::string points;
  for (std::size_t n = 0; n < kMaxPathPoints; ++n) points += fmt::format("[{}, 0],", n);
  const auto path = [](const std::string& list) {
    return "[[mover]]\nname = \"m\"\npath_m = [" + list + "]\n";
  };
  EXPECT_EQ(plain_with(path(points)).movers[0].path.path_m.size(), kMaxPathPoints);
  EXPECT_EQ(refusal_of(kPlainScene + path(points + "[0, 0]")).field, "mover.0.path_m");
}

class MotionRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(MotionRefusal, NamesTheField) {
  expect_refused(GetParam());
}

std::string mover(const std::string& keys) {
  return "[[mover]]\nname = \"m\"\n" + keys;
}

INSTANTIATE_TEST_SUITE_P(
    Values, MotionRefusal,
    ::testing::Values(
        Refusal{"damping_ratio = 0", "species.0.damping_ratio", "from 0.02 to 2"},
        Refusal{"drag_coefficient = 2.5", "species.0.drag_coefficient", "from 0 to 2"},
        Refusal{"wind = 3", "species.0.wind", "unknown key"},
        Refusal{"[wind]\nspeed_m_per_s = -1", "wind.speed_m_per_s",
                "found -1 in line 7, expected a number from 0"},
        Refusal{"[wind]\nspeed_m_per_s = 61", "wind.speed_m_per_s", "0 to 60"},
        Refusal{"[wind]\nspeed_m_per_s = nan", "wind.speed_m_per_s", "found nan"},
        Refusal{"[wind]\nheading_deg = 361", "wind.heading_deg", "-360 to 360"},
        Refusal{"[wind]\nheading = 3", "wind.heading", "did you mean 'heading_deg'?"},
        Refusal{"[wind]\nturbulence = 6", "wind.turbulence", "0 to 5"},
        Refusal{"[wind]\nfile = \"\"", "wind.file", "a CSV file"},
        Refusal{"[wind]\nfile = \"a\"\nspeed_m_per_s = 3", "wind.speed_m_per_s", "beside a file"},
        Refusal{"[wind]\nfile = \"a\"\nheading_deg = 3", "wind.heading_deg", "beside a file"},
        Refusal{"[wind]\nplace_m = [0, 0]", "wind.place_m", "a place without a file"},
        Refusal{"[wind]\nfile = \"a\"\nplace_m = [0, inf]", "wind.place_m", "found inf"},
        Refusal{"[[wind.whirl]]", "wind.whirl", "unknown key 'whirl'"},
        Refusal{"[[wind.whirl]]", "wind.whirl", "gust, tornado, breeze"},
        Refusal{"[[wind.tornadoe]]", "wind.tornadoe", "did you mean 'tornado'?"},
        Refusal{"[wind.gust]", "wind.gust", "[[wind.gust]]"},
        Refusal{"[[wind.gust]]\nwidth = 3", "wind.gust.0.width", "did you mean 'width_m'?"},
        Refusal{"[[wind.gust]]\nwidth_m = -3", "wind.gust.0.width_m", "found -3 in line 7, expected 0.01 to"},
        Refusal{"[[wind.gust]]\nwidth_m = nan", "wind.gust.0.width_m", "found nan in line 7"},
        Refusal{"[[wind.gust]]\nwidth_m = \"a\"", "wind.gust.0.width_m", "a number"},
        Refusal{"[[wind.gust]]\ntravel_m_per_s = 0", "wind.gust.0.travel_m_per_s", "found 0"},
        Refusal{"[[wind.gust]]\nheading_rad = 0", "wind.gust.0.heading_rad", "unknown key"},
        Refusal{"[[wind.gust]]\nposition_m = [0]", "wind.gust.0.position_m", "two numbers"},
        Refusal{"[[wind.gust]]\nposition_m = [0, nan]", "wind.gust.0.position_m", "found nan"},
        Refusal{"[[wind.gust]]\n[[wind.gust]]\nstart_s = inf", "wind.gust.1.start_s", "found inf"},
        Refusal{"[[wind.tornado]]\nradius_m = -1", "wind.tornado.0.radius_m", "found -1"},
        Refusal{"[[wind.tornado]]\nradius_m = 30", "wind.tornado.0.reach_m", "found 25, expected 30 to"},
        Refusal{"[[wind.tornado]]\nradius_m = 3\nreach_m = 2", "wind.tornado.0.reach_m", "found 2 in line 8"},
        Refusal{"[[wind.tornado]]\nseed = -1", "wind.tornado.0.seed", "4294967295"},
        Refusal{"[[wind.breeze]]\nperiod_s = 0", "wind.breeze.0.period_s", "found 0"},
        Refusal{"[[wind.breeze]]\nradius_m = -1e9", "wind.breeze.0.radius_m", "found -1000000000"},
        Refusal{"[treading]\nrecovery_s = 0", "treading.recovery_s", "found 0 in line 7"},
        Refusal{"[treading]\nrecovery = 1", "treading.recovery", "did you mean 'recovery_s'?"},
        Refusal{"[treading]\nmost_tilt_deg = 90", "treading.most_tilt_deg", "89.9"},
        Refusal{"[treading]\nmost_tilt_deg = 5", "treading.most_tilt_deg", "from 6"},
        Refusal{"[treading]\nspacing_m = 1", "treading.spacing_m", "0.05 to 0.5"},
        Refusal{"[treading]\nwear_passes = 0", "treading.wear_passes", "found 0"},
        Refusal{"[treading]\nworn_field = nan", "treading.worn_field", "found nan"},
        Refusal{"[treading]\nload_slowing = 1e300", "treading.load_slowing", "0 to 100"},
        Refusal{"[treading]\nworn_slowing = -1", "treading.worn_slowing", "0 to 100"},
        Refusal{"[treading]\nfield_scale = true", "treading.field_scale", "found true"},
        Refusal{"[[mover]]\npath_m = [[0, 0], [1, 1]]", "mover.0.name", "a name"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\n") + mover("path_m = [[0, 0], [1, 1]]"), "mover.1.name",
                "not yet given"},
        Refusal{mover(""), "mover.0.path_m", "2 to 1000 points"},
        Refusal{mover("path = [[0, 0], [1, 1]]"), "mover.0.path", "did you mean 'path_m'?"},
        Refusal{mover("path_m = [[0, 0]]"), "mover.0.path_m", "2 to 1000 points"},
        Refusal{mover("path_m = [0, 1]"), "mover.0.path_m", "no [x, y] as point 0"},
        Refusal{mover("path_m = [[0, 0], [1]]"), "mover.0.path_m", "no [x, y] as point 1"},
        Refusal{mover("path_m = [[0, 0], [1, \"a\"]]"), "mover.0.path_m", "a number from"},
        Refusal{mover("path_m = [[0, 0], [1, nan]]"), "mover.0.path_m", "a number from"},
        Refusal{mover("path_m = [[2, 2], [2, 2]]"), "mover.0.path_m", "no two places"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\nradius_m = -1"), "mover.0.radius_m", "0.05 to 3"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\nspeed_m_per_s = 21"), "mover.0.speed_m_per_s", "0 to 20"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\nstart_s = nan"), "mover.0.start_s", "found nan"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\nloops = 1"), "mover.0.loops", "true or false"},
        Refusal{mover("path_m = [[0, 0], [1, 1]]\nkind = \"ston\""), "mover.0.kind",
                "did you mean 'stone'?"}));

TEST(SceneWind, IsCalmWithoutOne) {
  const Wind wind = wind_of(plain_with(""));
  EXPECT_EQ(wind_m_per_s(wind, {3.0, 4.0}, 5.0), glm::vec2(0.0f));
  EXPECT_FALSE(wind.noise);
  EXPECT_FALSE(wind_of(plain_with("[wind]")).noise) << "calm air carries no turbulence";
}

TEST(SceneWind, BlowsTowardsItsHeading) {
  const auto mean = [](const char* heading) {
    const std::string text =
        std::string("[wind]\nspeed_m_per_s = 8\nturbulence = 0\nheading_deg = ") + heading;
    return wind_m_per_s(wind_of(plain_with(text)), {0.0, 0.0}, 0.0);
  };
  const auto is_near = [](glm::vec2 a, glm::vec2 b) {
    return std::abs(a.x - b.x) < 1e-4f && std::abs(a.y - b.y) < 1e-4f;
  };
  EXPECT_TRUE(is_near(mean("0"), {0.0f, 8.0f}));
  EXPECT_TRUE(is_near(mean("90"), {8.0f, 0.0f}));
  EXPECT_TRUE(is_near(mean("180"), {0.0f, -8.0f}));
  EXPECT_TRUE(is_near(mean("-90"), {-8.0f, 0.0f}));
}

TEST(SceneWind, TurbulenceFollowsFactorAndSeed) {
  const auto noise = [](const char* turbulence, const char* seed) {
    return wind_of(plain_with(std::string("[wind]\nspeed_m_per_s = 8\nturbulence = ") + turbulence,
                              {std::string("seed=") + seed}))
        .noise.value()
        .settings();
  };
  const NoiseWindSettings usual;
  for (std::size_t n = 0; n < usual.layers.size(); ++n) {
    EXPECT_FLOAT_EQ(noise("5", "1").layers[n].strength, 5.0f * usual.layers[n].strength);
    EXPECT_EQ(noise("5", "1").layers[n].size_m, usual.layers[n].size_m);
  }
  EXPECT_EQ(noise("1", "3").seed, noise("2", "3").seed);
  EXPECT_NE(noise("1", "3").seed, noise("1", "4").seed);
  EXPECT_NE(noise("1", "3").seed, noise("1", "4294967299").seed);
}

TEST(SceneWind, HasItsPrimitives) {
  const Wind wind =
      wind_of(plain_with("[wind]\n[[wind.breeze]]\nheading_deg = 0\nstrength_m_per_s = 3\nperiod_s = 4"));
  ASSERT_EQ(wind.primitives.size(), 1u);
  EXPECT_NEAR(wind_m_per_s(wind, {0.0, 0.0}, 1.0).y, 3.0f, 1e-3f);
}

TEST(SceneWind, ReplaysAMeasuredSeries) {
  const TemporaryFolder folder;
  testing::write_text(folder / "w.csv", "time_s,speed_m_per_s,direction_deg\n0,4,270\n10,8,270\n");
  const std::string text = std::string(kPlainScene) + "[wind]\nfile = \"w.csv\"\nplace_m = [5, 0]\n";
  const Wind wind = wind_of(parse_scene(text, folder.path(), {}));
  EXPECT_FALSE(wind.noise);
  EXPECT_NEAR(wind_m_per_s(wind, {5.0, 0.0}, 5.0).x, 6.0f, 1e-3f);
  EXPECT_LT(wind_m_per_s(wind, {11.0, 0.0}, 5.0).x, 5.9f) << "a second later downwind";
  EXPECT_TRUE(wind_of(parse_scene(text + "turbulence = 1\n", folder.path(), {})).noise);
}

TEST(SceneWind, AMeasuredSeriesHoldsInTheMiddleOfTheGround) {
  const TemporaryFolder folder;
  testing::write_text(folder / "w.csv", "time_s,speed_m_per_s,direction_deg\n0,4,270\n10,8,270\n");
  const std::string text = std::string(kPlainScene) + "[wind]\nfile = \"w.csv\"\n";
  const Wind wind = wind_of(parse_scene(text, folder.path(), {}), {500.0, 500.0});
  EXPECT_NEAR(wind_m_per_s(wind, {500.0, 500.0}, 5.0).x, 6.0f, 1e-3f);
}

TEST(SceneWind, RefusesAFileThatHoldsNone) {
  const TemporaryFolder folder;
  const std::string text = std::string(kPlainScene) + "[wind]\nfile = \"w.csv\"\n";
  const auto refused = [&](const char* rows) {
    testing::write_text(folder / "w.csv", std::string("time_s,speed_m_per_s,heading_rad\n") + rows);
    try {
      testing::open_scene(folder.path(), text);
    } catch (const BadInput& fault) {
      EXPECT_EQ(fault.file, (folder / "w.csv").string());
      EXPECT_FALSE(fault.expected.empty());
      return fault.field;
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused("0,5,0\n\n2,5,0\n"), "line 3");
  EXPECT_EQ(refused("0,5,0\n1,,0\n"), "line 3: speed_m_per_s");
  EXPECT_EQ(refused("0,5,0\n1,fresh,0\n"), "line 3: speed_m_per_s");
  EXPECT_EQ(refused("1,5,0\n0,5,0\n"), "line 3: time_s");
  EXPECT_EQ(refused("1,5,0\n2,5,0\n"), "nothing");
  std::filesystem::remove(folder / "w.csv");
  try {
    World(parse_scene(text, folder.path(), {}), {});
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.field, "wind.file");
  }
}

TEST(SceneWind, ItsFileCountsInTheHash) {
  const TemporaryFolder folder;
  const auto hash = [&](const char* name, const char* speed) {
    testing::write_text(folder / name, std::string("time_s,speed_m_per_s,heading_rad\n0,") + speed + ",0\n");
    return testing::open_scene(folder.path(), std::string(kPlainScene) + "[wind]\nfile = \"" + name + "\"\n")
        .scene_hash();
  };
  EXPECT_EQ(hash("a.csv", "5"), hash("b.csv", "5"));
  EXPECT_NE(hash("a.csv", "5"), hash("a.csv", "6"));
}

TEST(ChainTraits, AreThoseOfAMeanBlade) {
  const Scene scene = plain_with(
      "height_m = 0.8\nwidth_mm = 5\nmass_g = 0.4\nstiffness = 90\ndamping_ratio = 0.3\ndrag_coefficient = "
      "1");
  const ChainTraits traits = chain_traits_of(scene.species[0]);
  EXPECT_FLOAT_EQ(traits.half_segment_m, 0.1f);
  EXPECT_EQ(traits.stiffness, 90.0f);
  EXPECT_EQ(traits.damping_ratio, 0.3f);
  EXPECT_FLOAT_EQ(traits.drag, chain_drag(0.005f, 0.8f, 0.4f, 1.0f));
}

}  // namespace
}  // namespace prairie
