// Walkers in a world: scenes that describe them, states that hold them, tracks in their place, treads behind
// them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>

#include "agents/track_files.h"
#include "files/error.h"
#include "world/effort.h"
#include "world/motion.h"
#include "world/state_file.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr double kStepS = 1.0 / 30.0;

constexpr const char* kMeadow = R"(version = 1
seed = 5
[ground]
size_m = [60, 60]
[[species]]
name = "grass"
density = 900
height_m = 0.4
)";

constexpr const char* kPeople = R"(
[[obstacle]]
kind = "trunk"
position_m = [20, 20]
[[obstacle]]
kind = "box"
position_m = [30, 20]
size_m = [2, 1, 1]
heading_deg = 30
[[obstacle]]
kind = "rock"
position_m = [25, 28]
[[wall]]
outline_m = [[10, 10], [50, 10], [50, 50], [30, 50], [30, 40], [28, 40], [28, 50], [10, 50]]
[[goal]]
name = "well"
position_m = [40, 20]
[[goal]]
name = "gate"
position_m = [15, 35]
stay_s = 2
[[mover]]
name = "stone"
speed_m_per_s = 2
loops = true
path_m = [[20, 30], [40, 30], [40, 36]]
[[walkers]]
name = "wanderers"
count = 25
position_m = [28, 28]
radius_m = 14
[[walkers]]
name = "visitors"
count = 10
behaviour = "visit"
goals = ["well", "gate"]
position_m = [40, 40]
radius_m = 6
)";

World world_of(const std::string& more, const WorldOptions& options = {}) {
  return World(parse_scene(kMeadow + more, ".", {}), options);
}

void advance(World& world, int steps) {
  for (int n = 0; n < steps; ++n) world.step(kStepS);
}

TEST(Walkers, GoOnFromAStateAsIfNothingHadBeen) {
  const auto run = [](int first, std::size_t threads) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    World world = world_of(kPeople);
    advance(world, first);
    World later = world_of(kPeople);
    later.load_state(world.saved_state(), "walk.state");
    advance(later, 240 - first);
    return later.saved_state();
  };
  const std::vector<std::byte> whole = run(0, 2);
  EXPECT_TRUE(run(100, 1) == whole);
  EXPECT_TRUE(run(171, 3) == whole);
}

TEST(Walkers, ReachTheirGoals) {
  World world = world_of(kPeople);
  std::vector<int> visits(world.walkers().size(), 0);
  std::vector<int> last(world.walkers().size(), 0);
  for (int n = 0; n < 6 * 60 * 30; ++n) {
    world.step(kStepS);
    for (std::size_t w = 25; w < world.walkers().size(); ++w) {
      if (world.walkers()[w].memory.goal != last[w]) ++visits[w];
      last[w] = world.walkers()[w].memory.goal;
    }
  }
  for (std::size_t w = 25; w < visits.size(); ++w) EXPECT_GE(visits[w], 3) << w;
}

// Straight ahead lies a bag of walls that is open behind the walker.
TEST(Walkers, LeaveADeadEndOnTheirWayToAGoal) {
  World world = world_of(R"(
[[wall]]
walkers = "outside"
outline_m = [[20, 20], [32, 20], [32, 32], [20, 32], [20, 31.5], [31.5, 31.5], [31.5, 20.5], [20, 20.5]]
[[goal]]
name = "beyond"
position_m = [40, 26]
[[walkers]]
name = "one"
starts_m = [[24, 26]]
behaviour = "go"
goals = ["beyond"]
)");
  double reached_s = -1.0;
  for (int n = 0; n < 120 * 30 && reached_s < 0.0; ++n) {
    world.step(kStepS);
    if (glm::distance(world.walkers()[0].position_m, {40.0, 26.0}) < 1.0) reached_s = world.time_s();
  }
  EXPECT_GT(reached_s, 0.0);
}

TEST(Walkers, ObeyWhoSteersThemButWalkThroughNothing) {
  World world = world_of(R"(
[[obstacle]]
kind = "box"
position_m = [30, 20]
size_m = [2, 20, 1]
heading_deg = 90
[[walkers]]
name = "one"
starts_m = [[24, 20]]
)");
  world.crowd().steer(0, {1.5, {1.0, 0.0}});
  advance(world, 20 * 30);
  const double radius_m = world.walker_traits()[0].radius_m;
  EXPECT_LT(world.walkers()[0].position_m.x, 29.0 - radius_m);
  EXPECT_GT(world.walkers()[0].position_m.x, 29.0 - radius_m - 0.01);
  world.crowd().release(0);
  advance(world, 20 * 30);
  EXPECT_GT(glm::distance(world.walkers()[0].position_m, {29.0, 20.0}), 2.0);
}

TEST(Walkers, AreSlowerInTallDenseGrassAndUphill) {
  const auto way_m = [](const std::string& species) {
    World world(parse_scene("version = 1\n[ground]\nsize_m = [90, 60]\n" + species + R"(
[[walkers]]
name = "one"
starts_m = [[10, 30]]
speed_spread = 0
noise = 0
)",
                            ".", {}),
                {});
    world.crowd().steer(0, {1.3, {1.0, 0.0}});
    advance(world, 20 * 30);
    return world.walkers()[0].position_m.x - 10.0;
  };
  const double lawn_m = way_m("[[species]]\nname = \"lawn\"\ndensity = 500\nheight_m = 0.05\n");
  const double reed_m = way_m("[[species]]\nname = \"reed\"\ndensity = 2000\nheight_m = 1.2\nwidth_mm = 8\n");
  EXPECT_NEAR(lawn_m, 1.3 * 20.0, 2.0);
  EXPECT_LT(reed_m, 0.75 * lawn_m);
}

TEST(Walkers, LeaveTheSceneAsItWasWhereThereAreNone) {
  EXPECT_TRUE(world_of("").walkers().empty());
  EXPECT_TRUE(world_of("[[walkers]]\nname = \"nobody\"\ncount = 0\nposition_m = [5, 5]\n").walkers().empty());
}

struct Fault {
  const char* text;
  const char* field;
};

class WalkerFaults : public testing::TestWithParam<Fault> {};

TEST_P(WalkerFaults, AreNamed) {
  try {
    world_of(GetParam().text);
    FAIL() << "nothing was refused";
  } catch (const BadInput& fault) {
    EXPECT_NE(fault.field.find(GetParam().field), std::string::npos) << fault.what();
    EXPECT_FALSE(fault.found.empty());
    EXPECT_FALSE(fault.expected.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, WalkerFaults,
    testing::Values(
        Fault{"[[wall]]\noutline_m = [[0, 0], [10, 10], [10, 0], [0, 10]]\n", "wall.0"},
        Fault{"[[wall]]\noutline_m = [[0, 0], [10, 0]]\n", "wall.0.outline_m"},
        Fault{
            "[[wall]]\noutline_m = [[0, 0], [10, 0], [10, 10]]\nholes_m = [[[20, 20], [21, 20], [21, 21]]]\n",
            "wall.0"},
        Fault{"[[obstacle]]\nkind = \"trunk\"\nposition_m = [5, 5]\nradius_m = -1\n", "obstacle.0.radius_m"},
        Fault{"[[obstacle]]\nkind = \"rock\"\nposition_m = [5, nan]\n", "obstacle.0.position_m"},
        Fault{"[[obstacle]]\nposition_m = [5, 5]\n", "obstacle.0.kind"},
        Fault{"[[obstacle]]\nkind = \"trunk\"\nposition_m = [5, 5]\n[[walkers]]\nname = \"one\"\nstarts_m = "
              "[[5.1, 5]]\n",
              "starts_m"},
        Fault{"[[walkers]]\nname = \"two\"\nstarts_m = [[5, 5], [5.1, 5]]\n", "starts_m"},
        Fault{"[[wall]]\noutline_m = [[0, 0], [10, 0], [10, 10], [0, 10]]\n[[walkers]]\nname = "
              "\"out\"\nstarts_m = [[15, 5]]\n",
              "starts_m"},
        Fault{"[[walkers]]\nname = \"many\"\ncount = 1000000\nposition_m = [5, 5]\n", "walkers.0.count"},
        Fault{"[[walkers]]\nname = \"some\"\ncount = -1\nposition_m = [5, 5]\n", "walkers.0.count"},
        Fault{"[[walkers]]\nname = \"tight\"\ncount = 1000\nposition_m = [5, 5]\nradius_m = 2\n",
              "walkers.radius_m"},
        Fault{"[[walkers]]\nname = \"lost\"\n", "walkers.0.position_m"},
        Fault{"[[walkers]]\nname = \"odd\"\nposition_m = [5, 5]\nbehaviour = \"fly\"\n",
              "walkers.0.behaviour"},
        Fault{"[[walkers]]\nname = \"odd\"\nposition_m = [5, 5]\nbehaviour = \"visit\"\n", "walkers.0.goals"},
        Fault{"[[walkers]]\nname = \"odd\"\nposition_m = [5, 5]\nbehaviour = \"visit\"\ngoals = "
              "[\"nowhere\"]\n",
              "walkers.0.goals"},
        Fault{"[[walkers]]\nname = \"odd\"\nposition_m = [5, 5]\nsensor_m = inf\n", "walkers.0.sensor_m"},
        Fault{"[[goal]]\nname = \"a\"\nposition_m = [1, 2]\n[[goal]]\nname = \"a\"\nposition_m = [1, 2]\n",
              "goal.1.name"}));

TEST(WalkerStates, OfOtherWalkersAreRefused) {
  World world = world_of(kPeople);
  advance(world, 30);
  std::vector<Walker> walkers(world.walkers().begin(), world.walkers().end());
  const std::vector<Walker> kept = walkers;
  const auto refused = [&](const std::vector<Walker>& changed) {
    const StateOwner owner{world.motion_hash(), world.scene().treading};
    EXPECT_THROW(world.load_state(state_bytes({world.motion().state(), changed}, owner), "x"), BadInput);
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), world.walkers().begin()));
  };
  walkers.pop_back();
  refused(walkers);
  for (const auto& spoil :
       {+[](Walker& w) {
          w.forward = {0.0, 0.0};
        },
        +[](Walker& w) { w.memory.goal = 7; }, +[](Walker& w) { w.footing.phase = 3.0; },
        +[](Walker& w) { w.position_m.x = 1e9; }, +[](Walker& w) { w.speed_m_per_s = -1.0; }}) {
    walkers = kept;
    spoil(walkers[3]);
    refused(walkers);
  }
}

TEST(ReplayedTracks, TreadVisiblePathsAndKeepToTheData) {
  const char* folder = std::getenv("PRAIRIE_DATA");
  if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of recorded tracks";
  const std::filesystem::path file = std::filesystem::path(folder) / "peds_ucy_zara/zara01/obsmat.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "PRAIRIE_DATA holds no peds_ucy_zara";
  const std::vector<Track> tracks = placed(read_tracks(file, "tracks").tracks, {30.0, 15.0}, 0.0);
  World world = world_of("[treading]\nrecovery_s = 600\n");
  world.replay(tracks);
  double worst_m = 0.0, worst_cosine = 1.0;
  std::size_t compared = 0;
  // 25 frames a second, from the first stamp on.
  for (int frame = 1; frame <= 2500; ++frame) {
    world.step(1.0 / 25.0);
    for (std::size_t n = 0; n < tracks.size(); ++n) {
      const std::vector<double>& times_s = tracks[n].times_s;
      const auto at = std::lower_bound(times_s.begin(), times_s.end(), world.time_s() - 1e-6);
      if (at == times_s.end() || std::abs(*at - world.time_s()) > 1e-6) continue;
      const auto k = static_cast<std::size_t>(at - times_s.begin());
      worst_m = std::max(worst_m, glm::distance(world.walkers()[n].position_m, tracks[n].positions_m[k]));
      ++compared;
      if (k == 0 || k + 1 == times_s.size()) continue;
      const glm::dvec2 way = tracks[n].positions_m[k + 1] - tracks[n].positions_m[k - 1];
      if (glm::length(way) > 0.6)
        worst_cosine = std::min(worst_cosine, glm::dot(glm::normalize(way), world.walkers()[n].forward));
    }
  }
  fmt::print("{} positions, worst {:.2e} m, heading within {:.1f} degrees\n", compared, worst_m,
             std::acos(worst_cosine) * 57.29578);
  EXPECT_GT(compared, 500u);
  EXPECT_LE(worst_m, 0.01);
  EXPECT_GT(worst_cosine, 0.7);
  // Where people went most, the grass lies; a metre beside the pavement it stands.
  int trodden = 0, nodes = 0;
  for (double y = 20.0; y < 30.0; y += 0.25) {
    for (double x = 23.0; x < 36.0; x += 0.25) {
      trodden += world.motion().treading().sample({x, y}).tilt_rad > 0.3f ? 1 : 0;
      ++nodes;
    }
  }
  fmt::print("{:.1f} % of the pavement lies\n", 100.0 * trodden / nodes);
  EXPECT_GT(trodden, nodes / 50);
  EXPECT_EQ(world.motion().treading().sample({30.0, 45.0}).tilt_rad, 0.0f);
}

TEST(WalkersLongTest, AnHourOfAThousandIsFiniteAndTheSameAgain) {
  std::string text = kMeadow;
  const std::string people = R"([[wall]]
outline_m = [[0, 0], [160, 0], [160, 160], [0, 160]]
[[obstacle]]
kind = "rock"
position_m = [80, 80]
size_m = [3, 2, 1]
[[walkers]]
name = "people"
count = 1000
position_m = [80, 80]
radius_m = 75
)";
  const auto hour = [&] {
    World world = world_of(people);
    std::size_t bytes_early = 0;
    for (int n = 0; n < 3600 * 30; ++n) {
      world.step(kStepS);
      if (n == 20 * 60 * 30) bytes_early = world.motion().treading().bytes();
    }
    for (const Walker& walker : world.walkers()) {
      EXPECT_TRUE(std::isfinite(walker.position_m.x + walker.position_m.y + walker.speed_m_per_s +
                                walker.footing.phase));
    }
    // All of the meadow has been walked on after twenty minutes: nothing grows from then on.
    EXPECT_NEAR(static_cast<double>(world.motion().treading().bytes()), static_cast<double>(bytes_early),
                0.01 * static_cast<double>(bytes_early));
    return world.saved_state();
  };
  EXPECT_TRUE(hour() == hour());
}

}  // namespace
}  // namespace prairie
