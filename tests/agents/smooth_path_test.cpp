#include "agents/smooth_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace prairie {
namespace {

using Points = std::vector<glm::dvec2>;

// Short and long spans side by side, and a sharp corner.
const Points kUneven{{0.0, 0.0}, {1.0, 0.5}, {30.0, 2.0}, {31.0, -8.0}, {12.0, -9.0}, {11.0, -8.5}};

double nearest_m(const SmoothPath& way, glm::dvec2 point_m) {
  double least_m = 1e9;
  for (double at_m = 0.0; at_m <= way.length_m(); at_m += 1e-3) {
    least_m = std::min(least_m, glm::length(way.at(at_m).position_m - point_m));
  }
  return least_m;
}

TEST(SmoothPath, IsStraightBetweenTwoPoints) {
  const SmoothPath way(Points{{1.0, 2.0}, {4.0, 6.0}}, false);
  EXPECT_NEAR(way.length_m(), 5.0, 1e-12);
  EXPECT_NEAR(glm::length(way.at(2.5).position_m - glm::dvec2(2.5, 4.0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(way.at(2.5).forward - glm::dvec2(0.6, 0.8)), 0.0, 1e-9);
}

TEST(SmoothPath, PassesThroughAllPoints) {
  for (const bool closed : {false, true}) {
    const SmoothPath way(kUneven, closed);
    for (const glm::dvec2 point_m : kUneven) EXPECT_LT(nearest_m(way, point_m), 1e-3);
  }
}

TEST(SmoothPath, HasAnEvenSpeed) {
  constexpr double kStepM = 0.01;
  for (const bool closed : {false, true}) {
    const SmoothPath way(kUneven, closed);
    for (double at_m = 0.0; at_m + kStepM < way.length_m(); at_m += kStepM) {
      const double gone_m = glm::length(way.at(at_m + kStepM).position_m - way.at(at_m).position_m);
      ASSERT_NEAR(gone_m / kStepM, 1.0, 0.01) << at_m;
    }
  }
}

TEST(SmoothPath, TurnsWithoutJumpsTowardsWhereItGoes) {
  constexpr double kStepM = 0.005;
  const SmoothPath way(kUneven, true);
  for (double at_m = 0.0; at_m < way.length_m(); at_m += kStepM) {
    const PathPlace here = way.at(at_m), next = way.at(at_m + kStepM);
    ASSERT_NEAR(glm::length(here.forward), 1.0, 1e-12);
    ASSERT_LT(glm::length(next.forward - here.forward), 0.1) << at_m;
    const glm::dvec2 gone = glm::normalize(next.position_m - here.position_m);
    ASSERT_GT(glm::dot(gone, here.forward), 0.995) << at_m;
  }
}

TEST(SmoothPath, IsNearlyACircleThroughPointsOfOne) {
  Points points_m;
  for (int n = 0; n < 12; ++n) {
    const double angle = n * std::numbers::pi / 6.0;
    points_m.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  const SmoothPath way(points_m, true);
  EXPECT_NEAR(way.length_m(), 20.0 * std::numbers::pi, 0.1);
  for (double at_m = 0.0; at_m < way.length_m(); at_m += 0.1)
    EXPECT_NEAR(glm::length(way.at(at_m).position_m), 10.0, 0.02);
}

TEST(SmoothPath, OpenEndsAndClosedGoesOn) {
  const SmoothPath open(kUneven, false), closed(kUneven, true);
  EXPECT_EQ(open.at(-5.0).position_m, kUneven.front());
  EXPECT_NEAR(glm::length(open.at(1e9).position_m - kUneven.back()), 0.0, 1e-8);
  EXPECT_GT(closed.length_m(), open.length_m() + 10.0);
  const double round_m = closed.length_m();
  EXPECT_NEAR(glm::length(closed.at(7.0).position_m - closed.at(7.0 + 3.0 * round_m).position_m), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(closed.at(-1.0).position_m - closed.at(round_m - 1.0).position_m), 0.0, 1e-9);
}

TEST(SmoothPath, MayLeadStraightBack) {
  for (const bool closed : {false, true}) {
    const SmoothPath way(Points{{0.0, 0.0}, {10.0, 0.0}, {0.0, 0.0}}, closed);
    EXPECT_NEAR(way.length_m(), 20.0, 1e-3);
    EXPECT_NEAR(way.at(5.0).position_m.x, 5.0, 1e-3);
    EXPECT_NEAR(way.at(15.0).position_m.x, 5.0, 1e-3);
    EXPECT_NEAR(way.at(15.0).forward.x, -1.0, 1e-9);
    for (double at_m = 0.0; at_m < 20.0; at_m += 1e-3) {
      ASSERT_NEAR(std::abs(way.at(at_m).forward.x), 1.0, 1e-9) << at_m;
      const double gone_m = glm::length(way.at(at_m + 1e-3).position_m - way.at(at_m).position_m);
      // It turns about within one of these steps.
      if (std::abs(at_m + 5e-4 - 10.0) < 2e-3 || at_m > 19.99) continue;
      ASSERT_NEAR(gone_m, 1e-3, 1e-5) << at_m;
    }
  }
}

TEST(SmoothPath, LeavesOutPointsThatAreTheSame) {
  const Points twice{{0.0, 0.0}, {0.0, 0.0}, {3.0, 4.0}, {3.0, 4.0 + 1e-5}, {9.0, 4.0}, {0.0, 0.0}};
  const Points once{{0.0, 0.0}, {3.0, 4.0}, {9.0, 4.0}};
  EXPECT_EQ(SmoothPath(twice, true).length_m(), SmoothPath(once, true).length_m());
  EXPECT_FALSE(has_length(Points{{1.0, 1.0}, {1.0, 1.0 + 1e-4}}));
  EXPECT_FALSE(has_length(Points{}));
  EXPECT_TRUE(has_length(once));
}

}  // namespace
}  // namespace prairie
