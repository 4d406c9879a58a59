// Grass that is trodden: how far it lies down, where to, and how it rises again.
#include "animation/treading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "tests/animation/random_walkers.h"

namespace prairie {
namespace {

/// A body walks from west to east through the origin, in steps of `dt_s`.
void walk(Treading& treading, double dt_s, glm::dvec2 from_m, glm::dvec2 to_m, double speed_m_per_s = 1.2,
          double radius_m = 0.1) {
  const double start_s = treading.state().time_s;
  const double length_m = std::hypot(to_m.x - from_m.x, to_m.y - from_m.y);
  const int steps = static_cast<int>(std::lround(length_m / speed_m_per_s / dt_s));
  for (int n = 0; n < steps; ++n) {
    TreadStep step;
    step.from_m = from_m + (to_m - from_m) * (static_cast<double>(n) / steps);
    step.to_m = from_m + (to_m - from_m) * (static_cast<double>(n + 1) / steps);
    step.radius_m = radius_m;
    treading.step({&step, 1}, start_s + (n + 1) * dt_s);
  }
}

void wait(Treading& treading, double seconds) {
  treading.step({}, treading.state().time_s + seconds);
}

TEST(TreadingTest, GrassUnderAPathLiesAlmostFlatAndFarGrassStands) {
  Treading treading(TreadSettings{});
  walk(treading, 1.0 / 60.0, {-3.0, 0.0}, {3.0, 0.0});
  const TreadSettings& settings = treading.settings();
  EXPECT_GT(treading.at({0, 0}).tilt_rad, 0.93f * settings.most_tilt_rad);
  EXPECT_LT(treading.at({0, 0}).tilt_rad, settings.most_tilt_rad);
  float previous = 10.0f;
  for (int j = 0; j < 3; ++j) {
    const Tread tread = treading.at({0, j});
    EXPECT_LT(tread.tilt_rad, previous) << "falls to the side";
    previous = tread.tilt_rad;
  }
  EXPECT_EQ(treading.at({0, 3}).tilt_rad, 0.0f) << "beyond the reach of 0.3 m";
  EXPECT_EQ(treading.sample({0.0, 100.0}).tilt_rad, 0.0f);
}

TEST(TreadingTest, BladesLeanOutwardAndForward) {
  Treading treading(TreadSettings{});
  walk(treading, 1.0 / 60.0, {-3.0, 0.01}, {3.0, 0.01});
  for (int j = -2; j <= 2; ++j) {
    const Tread tread = treading.at({3, j});
    EXPECT_GT(tread.lean_rad.x, 0.0f) << j;
    EXPECT_GT(tread.lean_rad.y * (j > 0 ? 1.0f : -1.0f), 0.0f) << j;
    EXPECT_NEAR(std::hypot(tread.lean_rad.x, tread.lean_rad.y), tread.tilt_rad, 0.03f)
        << "all but the worn part";
  }
}

TEST(TreadingTest, APassDoesNotDependOnTheTimeStep) {
  Treading coarse(TreadSettings{}), fine(TreadSettings{});
  walk(coarse, 1.0 / 30.0, {-3.0, 0.03}, {3.0, 0.3});
  walk(fine, 1.0 / 60.0, {-3.0, 0.03}, {3.0, 0.3});
  float worst = 0.0f;
  for (int i = -16; i <= 16; ++i) {
    for (int j = -5; j <= 7; ++j) {
      const float a = field_of(coarse.state().nodes.at({i, j}), coarse.state().time_s);
      const float b = field_of(fine.state().nodes.at({i, j}), fine.state().time_s);
      worst = std::max(worst, std::abs(a - b) / std::max(b, 0.02f));
    }
  }
  std::printf("halving the time step changes a node's F by at most %.2g %%\n",
              100.0 * static_cast<double>(worst));
  EXPECT_LT(worst, 0.01f);
}

TEST(TreadingTest, CrushedBladesDoNotTurn) {
  Treading treading(TreadSettings{});
  walk(treading, 1.0 / 60.0, {-2.0, 0.0}, {2.0, 0.0});
  const Tread once = treading.at({0, 1});
  wait(treading, 5.0);
  const Tread risen = treading.at({0, 1});
  ASSERT_LT(risen.tilt_rad, once.tilt_rad);
  walk(treading, 1.0 / 60.0, {0.0, 2.0}, {0.0, -2.0});  // across
  const Tread twice = treading.at({0, 1});
  EXPECT_GT(twice.tilt_rad, risen.tilt_rad) << "the vertical part is renewed";
  const float turn =
      std::atan2(twice.lean_rad.y, twice.lean_rad.x) - std::atan2(once.lean_rad.y, once.lean_rad.x);
  EXPECT_NEAR(turn, 0.0f, 1e-5f);
}

TEST(TreadingTest, AStandingBodyKeepsGrassPressed) {
  Treading treading(TreadSettings{});
  walk(treading, 1.0 / 60.0, {-2.0, 0.0}, {0.0, 0.0});
  const float arrived = treading.at({0, 0}).tilt_rad, beside = treading.at({0, 1}).tilt_rad;
  TreadStep standing;
  for (int n = 0; n < 60 * 120; ++n) treading.step({&standing, 1}, treading.state().time_s + 1.0 / 60.0);
  EXPECT_GE(treading.at({0, 0}).tilt_rad, arrived) << "after two minutes";
  EXPECT_GT(treading.at({0, 1}).tilt_rad, 0.95f * beside);
  EXPECT_LT(treading.at({-8, 0}).tilt_rad, 0.03f) << "where it came from, but for wear";
}

TEST(TreadingTest, AFootThatComesDownPressesAtOnceWhateverTheTimeStep) {
  for (const double dt_s : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 20.0}) {
    Treading treading(TreadSettings{});
    TreadStep foot;
    foot.from_m = foot.to_m = {0.01, 0.0};
    for (int n = 1; n * dt_s <= 0.2001; ++n) treading.step({&foot, 1}, n * dt_s);
    EXPECT_NEAR(treading.at({0, 0}).tilt_rad, 1.16f, 0.03f) << dt_s;
    EXPECT_GT(treading.at({1, 0}).lean_rad.x, 0.0f);
    EXPECT_LT(treading.at({-1, 0}).lean_rad.x, 0.0f);
  }
}

/// Bar of all: after any sequence of treads every node left alone comes to its rest in its time and never
/// turns back.
TEST(TreadingTest, EveryNodeReturnsMonotonicallyInItsTime) {
  TreadSettings settings;
  settings.wear_passes = 5.0f;
  Treading treading(settings);
  const RandomWalkers walkers(40, 6.0, 1.0 / 60.0);
  for (int step = 0; step < 900; ++step) treading.step(walkers.steps(step), (step + 1) / 60.0);

  std::map<std::pair<int, int>, Tread> previous;
  std::map<std::pair<int, int>, double> rest_s;
  double last_rest_s = 0.0;
  for (const auto& [page, nodes] : treading.state().nodes.pages()) {
    const NodeIndex corner = page.south_west();
    for (int slot = 0; slot < kPageNodes * kPageNodes; ++slot) {
      const TreadNode& node = nodes[static_cast<std::size_t>(slot)];
      if (node.field == 0.0f) continue;
      const NodeIndex index{corner.i + slot % kPageNodes, corner.j + slot / kPageNodes};
      previous[{index.i, index.j}] = treading.at(index);
      rest_s[{index.i, index.j}] = rest_time_s(node);
      // The longest that settings allow: load and wear both at their most.
      EXPECT_LE(rest_time_s(node) - treading.state().time_s,
                settings.recovery_s *
                    static_cast<double>((1.0f + settings.load_slowing) * (1.0f + settings.worn_slowing)));
      last_rest_s = std::max(last_rest_s, rest_time_s(node));
    }
  }
  ASSERT_GT(previous.size(), 1000u);
  int worn_nodes = 0;
  while (treading.state().time_s <= last_rest_s) {
    wait(treading, 0.731);
    for (auto& [index, tread] : previous) {
      const Tread now = treading.at({index.first, index.second});
      ASSERT_LE(now.tilt_rad, tread.tilt_rad);
      ASSERT_LE(std::hypot(now.lean_rad.x, now.lean_rad.y),
                std::hypot(tread.lean_rad.x, tread.lean_rad.y) + 1e-6f);
      const float turn = now.lean_rad.x * tread.lean_rad.y - now.lean_rad.y * tread.lean_rad.x;
      ASSERT_NEAR(turn, 0.0f, 1e-5f);
      ASSERT_EQ(now.wear, tread.wear);
      if (treading.state().time_s >= rest_s[index]) {
        ASSERT_EQ(now.lean_rad, glm::vec2(0.0f));
        const float worn = settings.worn_field * now.wear / settings.field_scale;
        ASSERT_NEAR(now.tilt_rad, settings.most_tilt_rad * (1.0f - std::exp(-worn)), 1e-5f);
        worn_nodes += now.wear > 0.1f;
      }
      tread = now;
    }
  }
  EXPECT_GT(worn_nodes, 0);
  wait(treading, 1.0);
  EXPECT_TRUE(treading.state().nodes.pages().empty()) << "all at rest, all freed";
}

TEST(TreadingTest, RepeatedTreadingWearsAPath) {
  Treading treading(TreadSettings{});
  const auto pass = [&] {
    walk(treading, 1.0 / 60.0, {-1.5, 0.0}, {1.5, 0.0});
    const double recovery_s = rest_time_s(treading.state().nodes.at({0, 0})) - treading.state().time_s;
    wait(treading, 400.0);
    return recovery_s;
  };
  const double first_s = pass();
  const Tread once = treading.at({0, 0});
  EXPECT_LT(once.tilt_rad, 0.05f) << "one pass leaves next to nothing";
  double last_s = 0.0;
  for (int n = 0; n < 39; ++n) last_s = pass();
  const Tread worn = treading.at({0, 0});
  EXPECT_NEAR(worn.wear, 0.63f, 0.02f) << "after wear_passes";
  EXPECT_GT(worn.tilt_rad, 10.0f * once.tilt_rad) << "recovery is incomplete";
  EXPECT_GT(last_s, 1.5 * first_s) << "and slower";
  EXPECT_EQ(worn.lean_rad, glm::vec2(0.0f));

  // Wear is a map.
  const NodeRect rect{-20, -5, 40, 10};
  std::vector<float> wear(400);
  treading.read_wear(rect, wear);
  EXPECT_EQ(wear[5 * 40 + 20], worn.wear);
  Treading later(TreadSettings{});
  later.write_wear(rect, wear);
  EXPECT_EQ(later.at({0, 0}).tilt_rad, worn.tilt_rad);
}

TEST(TreadingTest, SpeciesAndLoadSetTheTime) {
  Treading slow(TreadSettings{}, NodeGrid::uniform(600.0f)), fast(TreadSettings{}, NodeGrid::uniform(6.0f));
  walk(slow, 1.0 / 60.0, {-1.0, 0.0}, {1.0, 0.0});
  walk(fast, 1.0 / 60.0, {-1.0, 0.0}, {1.0, 0.0});
  const auto left_s = [](const Treading& treading, NodeIndex node) {
    return rest_time_s(treading.state().nodes.at(node)) - treading.state().time_s;
  };
  EXPECT_GT(left_s(slow, {0, 0}), 80.0 * left_s(fast, {0, 0}));
  EXPECT_GT(left_s(slow, {0, 0}), 1.2 * left_s(slow, {0, 2})) << "heavier on the path than beside it";
}

TEST(TreadingTest, PassingByDoesNotHoldUpARecovery) {
  // Someone walks to and fro beside a path that was trodden once.
  Treading treading(TreadSettings{}), left_alone(TreadSettings{});
  for (Treading* one : {&treading, &left_alone}) walk(*one, 1.0 / 60.0, {-1.0, 0.0}, {1.0, 0.0});
  for (int n = 0; n < 4; ++n) {
    wait(treading, 6.0);
    walk(treading, 1.0 / 60.0, {-1.0, 0.295}, {1.0, 0.295});
  }
  wait(left_alone, treading.state().time_s - left_alone.state().time_s);
  EXPECT_NEAR(treading.at({0, 0}).tilt_rad, left_alone.at({0, 0}).tilt_rad, 0.1f);
  EXPECT_LT(treading.at({0, 0}).tilt_rad, 1.25f);
}

TEST(TreadingTest, MemoryFollowsTheAreaTouched) {
  Treading treading(TreadSettings{});
  EXPECT_EQ(treading.bytes(), 0u);
  walk(treading, 1.0 / 60.0, {-50.0, 0.0}, {50.0, 0.0}, 3.0);
  // Pages of 2 m on either side of a 100 m path, each of 256 nodes of 36 bytes.
  EXPECT_LE(treading.bytes(), 2u * 52u * (256u * 36u + 128u));
  wait(treading, 1000.0);
  EXPECT_TRUE(treading.state().nodes.pages().empty());
}

TEST(TreadingTest, ReadsBlocksAsItReadsNodes) {
  Treading treading(TreadSettings{});
  const RandomWalkers walkers(20, 8.0, 1.0 / 60.0);
  for (int step = 0; step < 60; ++step) treading.step(walkers.steps(step), (step + 1) / 60.0);
  const NodeRect rect{-37, -21, 70, 55};
  std::vector<glm::vec4> block(70 * 55, glm::vec4(9.0f));
  treading.read(rect, block);
  int trodden = 0;
  for (int row = 0; row < rect.rows; ++row) {
    for (int column = 0; column < rect.columns; ++column) {
      const Tread tread = treading.at({rect.column + column, rect.row + row});
      const glm::vec4 expected(tread.lean_rad.x, tread.lean_rad.y, tread.tilt_rad, tread.wear);
      ASSERT_EQ(block[static_cast<std::size_t>(row * rect.columns + column)], expected);
      trodden += tread.tilt_rad > 0.5f;
    }
  }
  EXPECT_GT(trodden, 100);
}

TEST(TreadingTest, SamplesBetweenNodesAlsoAcrossPages) {
  Treading treading(TreadSettings{});
  const RandomWalkers walkers(20, 8.0, 1.0 / 60.0);
  for (int step = 0; step < 60; ++step) treading.step(walkers.steps(step), (step + 1) / 60.0);
  const double spacing_m = treading.settings().spacing_m;
  for (double y = -3.0; y < 3.0; y += 0.093) {
    for (double x = -3.0; x < 3.0; x += 0.071) {
      const NodeSquare square = square_of({x, y}, spacing_m);
      const auto [i, j] = square.south_west;
      const auto tilt = [&](int di, int dj) { return treading.at({i + di, j + dj}).tilt_rad; };
      const float south = tilt(0, 0) + (tilt(1, 0) - tilt(0, 0)) * square.east;
      const float north = tilt(0, 1) + (tilt(1, 1) - tilt(0, 1)) * square.east;
      ASSERT_NEAR(treading.sample({x, y}).tilt_rad, south + (north - south) * square.north, 1e-6f)
          << x << ' ' << y;
    }
  }
}

/// Measured, not held to a bound: the machine that runs the suite may be busy.
TEST(TreadingTest, StepOfAThousandBodies) {
  Treading treading(TreadSettings{});
  const RandomWalkers walkers(1000, 100.0, 1.0 / 60.0);
  std::vector<double> times_ms;
  for (int step = 0; step < 180; ++step) {
    std::vector<TreadStep> steps = walkers.steps(step);
    for (TreadStep& one : steps) one.radius_m = 0.1;
    const auto start = std::chrono::steady_clock::now();
    treading.step(steps, (step + 1) / 60.0);
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times_ms.begin(), times_ms.end());
  std::printf("1000 bodies: median %.2f ms, 90th percentile %.2f ms a step, %.1f MB\n", times_ms[90],
              times_ms[162], 1e-6 * static_cast<double>(treading.bytes()));
  EXPECT_LT(times_ms[90], 200.0);
}

}  // namespace
}  // namespace prairie
