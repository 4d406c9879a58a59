// The spline blade: a chain in equilibrium, the spline through its joints, and its change into a Hermite
// blade.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <utility>

#include "shaders/kernels/kernels.h"
#include "tests/lod/energy_chain.h"

namespace prairie {
namespace {

using Chain = Kernels::BladeChain;
using Curve = Kernels::BladeCurve;

double uniform(std::mt19937& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// Blades of an ordinary meadow: little tilt, a quarter turn at most.
Blade meadow_blade(std::mt19937& random) {
  Blade blade{};
  blade.root_m = {static_cast<float>(uniform(random, 0.0, 4.0)),
                  static_cast<float>(uniform(random, 0.0, 4.0))};
  blade.ground_m = 0.5f;
  blade.height_m = static_cast<float>(uniform(random, 0.1, 0.6));
  blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 6.283));
  blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 0.21));
  blade.curvature_rad = static_cast<float>(uniform(random, 0.4, 1.2));
  const double heading = uniform(random, 0.0, 6.283), lean = uniform(random, 0.0, 0.45);
  blade.lean = {static_cast<float>(lean * std::cos(heading)), static_cast<float>(lean * std::sin(heading))};
  blade.stiffness = 60.0f;
  return blade;
}

/// Anything that a scene file can ask for, and more.
Blade extreme_blade(std::mt19937& random) {
  Blade blade = meadow_blade(random);
  blade.height_m = static_cast<float>(std::exp(uniform(random, std::log(0.01), std::log(3.0))));
  blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 1.5));
  blade.curvature_rad = static_cast<float>(uniform(random, 0.0, 3.5));
  blade.lean = {static_cast<float>(uniform(random, -1.0, 1.0)),
                static_cast<float>(uniform(random, -1.0, 1.0))};
  blade.stiffness = static_cast<float>(std::exp(uniform(random, 0.0, std::log(1e6))));
  return blade;
}

glm::vec2 slope(std::mt19937& random, double most) {
  return {static_cast<float>(uniform(random, -most, most)), static_cast<float>(uniform(random, -most, most))};
}

std::array<glm::vec3, 5> joints_of(const Chain& chain) {
  return {chain.p0, chain.p1, chain.p2, chain.p3, chain.p4};
}

Chain hang(const Blade& blade, glm::vec2 ground = {0.0f, 0.0f}, float growth = 1.0f) {
  return Kernels{}.chain_of(blade, Kernels{}.pose_blade(blade, ground, growth), growth);
}

glm::dvec3 point_on(const Curve& curve, float t) {
  return glm::dvec3(
      Kernels{}.hermite_point(curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m, t));
}

glm::dvec3 point_on(const Chain& chain, float u) {
  return glm::dvec3(Kernels{}.chain_point(chain, u));
}

template <typename Shape>
double arc_length_m(const Shape& shape) {
  double length_m = 0.0;
  for (int n = 0; n < 400; ++n) {
    length_m += glm::distance(point_on(shape, static_cast<float>(n) / 400.0f),
                              point_on(shape, static_cast<float>(n + 1) / 400.0f));
  }
  return length_m;
}

double relative_gap(const Chain& chain, const Curve& curve, float height_m) {
  double most = 0.0;
  for (int n = 0; n <= 100; ++n) {
    const float u = static_cast<float>(n) / 100.0f;
    most = std::max(most, glm::distance(point_on(chain, u), point_on(curve, u)));
  }
  return most / static_cast<double>(height_m);
}

/// Distance of the tip from that of least energy, as a share of the blade's length.
double tip_error(const Blade& blade, glm::vec2 ground) {
  const Curve rest = Kernels{}.pose_blade(blade, ground, 1.0f);
  const Chain chain = Kernels{}.chain_of(blade, rest, 1.0f);
  const EnergyChain exact(blade, rest);
  EXPECT_LT(exact.residual(), 1e-5);
  const double segment_m = glm::distance(glm::dvec3(chain.p0), glm::dvec3(chain.p1));
  glm::dvec3 tip(chain.p0);
  const auto direction = exact.directions();
  for (int i = 0; i < 4; ++i) tip += direction[i] * segment_m;
  return glm::distance(tip, glm::dvec3(chain.p4)) / static_cast<double>(blade.height_m);
}

TEST(ChainTest, HangsWhereSpringsAndWeightHaveTheLeastEnergy) {
  struct Case {
    float stiffness;
    double meadow_limit;
    double extreme_limit;
  };
  for (const Case& c : {Case{1e4f, 0.0005, 0.0005}, Case{120.0f, 0.001, 0.002}, Case{60.0f, 0.0025, 0.005},
                        Case{40.0f, 0.01, 0.018}, Case{28.0f, 0.04, 0.06}, Case{20.0f, 0.2, 0.25}}) {
    std::mt19937 random(31);
    double meadow = 0.0, extreme = 0.0;
    for (int n = 0; n < 150; ++n) {
      Blade blade = meadow_blade(random);
      blade.stiffness = c.stiffness;
      meadow = std::max(meadow, tip_error(blade, slope(random, 0.25)));
      blade = extreme_blade(random);
      blade.tilt_rad = std::min(blade.tilt_rad, 1.4f);
      blade.lean *= 0.6f;
      blade.stiffness = c.stiffness;
      extreme = std::max(extreme, tip_error(blade, slope(random, 0.5)));
    }
    std::printf("stiffness %5.0f: tip within %.2f %% of the length in a meadow, %.2f %% at the extremes\n",
                static_cast<double>(c.stiffness), 100.0 * meadow, 100.0 * extreme);
    EXPECT_LE(meadow, c.meadow_limit);
    EXPECT_LE(extreme, c.extreme_limit);
  }
}

TEST(ChainTest, StiffBladesKeepTheShapeOfTheArc) {
  std::mt19937 random(32);
  double tip = 0.0, gap = 0.0;
  for (int n = 0; n < 2000; ++n) {
    Blade blade = extreme_blade(random);
    blade.stiffness = 1e6f;
    const Curve rest = Kernels{}.pose_blade(blade, slope(random, 0.8), 1.0f);
    const Chain chain = Kernels{}.chain_of(blade, rest, 1.0f);
    tip = std::max(tip, static_cast<double>(glm::distance(chain.p4, rest.tip_m) / blade.height_m));
    gap = std::max(gap, relative_gap(chain, rest, blade.height_m));
  }
  std::printf("tip within %.3f %%, curve within %.3f %% of the length\n", 100.0 * tip, 100.0 * gap);
  EXPECT_LE(tip, 0.005);
  EXPECT_LE(gap, 0.013) << "pose_blade's cubic itself strays so far from its arc at a turning of 2.6 rad";
}

TEST(ChainTest, StiffCurveLiesOnTheArcForTurningsUpToTwo) {
  std::mt19937 random(33);
  for (int n = 0; n < 500; ++n) {
    Blade blade = meadow_blade(random);
    blade.lean = {0.0f, 0.0f};
    blade.curvature_rad = static_cast<float>(uniform(random, 0.0, 2.0));
    blade.stiffness = 1e6f;
    const Curve rest = Kernels{}.pose_blade(blade, {0.0f, 0.0f}, 1.0f);
    ASSERT_LE(relative_gap(Kernels{}.chain_of(blade, rest, 1.0f), rest, blade.height_m), 0.01);
  }
}

TEST(ChainTest, SegmentsAreEqualAndTheSplineHasTheBladesLength) {
  std::mt19937 random(34);
  double spline = 0.0, hermite = 0.0;
  for (int n = 0; n < 2000; ++n) {
    Blade blade = extreme_blade(random);
    blade.root_m = {0.0f, 0.0f};
    blade.ground_m = 0.0f;
    const Chain chain = hang(blade, slope(random, 0.8));
    const auto p = joints_of(chain);
    for (int i = 1; i < 4; ++i) {
      ASSERT_NEAR(glm::distance(p[i], p[i + 1]) / glm::distance(p[0], p[1]), 1.0f, 1e-5f);
    }
    const double height_m = static_cast<double>(blade.height_m);
    ASSERT_LE(4.0f * glm::distance(p[0], p[1]), blade.height_m * 1.00001f);
    spline = std::max(spline, std::abs(arc_length_m(chain) / height_m - 1.0));
    hermite = std::max(hermite, std::abs(arc_length_m(Kernels{}.curve_of(chain)) / height_m - 1.0));
  }
  std::printf("length within %.3f %% for the spline, %.2f %% for its Hermite curve\n", 100.0 * spline,
              100.0 * hermite);
  EXPECT_LE(spline, 0.005);
  EXPECT_LE(hermite, 0.015);
}

TEST(ChainTest, SofterBladesHangLower) {
  std::mt19937 random(35);
  for (int n = 0; n < 500; ++n) {
    Blade blade = meadow_blade(random);
    const glm::vec2 ground = slope(random, 0.25);
    float above_m = Kernels{}.pose_blade(blade, ground, 1.0f).tip_m.z + 1e-5f;
    for (const float stiffness :
         {1e6f, 1e4f, 1e3f, 300.0f, 120.0f, 80.0f, 60.0f, 50.0f, 40.0f, 34.0f, 28.0f, 24.0f}) {
      blade.stiffness = stiffness;
      const float tip_m = hang(blade, ground).p4.z;
      ASSERT_LT(tip_m, above_m) << "stiffness " << stiffness;
      above_m = tip_m;
    }
    blade.stiffness = 1.0f;
    ASSERT_LE(hang(blade, ground).p4.z, above_m) << "softer than any that stands";
  }
}

TEST(ChainTest, UprightStraightBladesStayUpright) {
  Blade blade{};
  blade.height_m = 0.5f;
  for (const float stiffness : {1.0f, 20.0f, 60.0f, 1e4f}) {
    blade.stiffness = stiffness;
    const Chain chain = hang(blade);
    EXPECT_NEAR(chain.p4.z, 0.5f, 1e-5f);
    EXPECT_NEAR(chain.p4.x, 0.0f, 2e-5f);
    EXPECT_NEAR(chain.p4.y, 0.0f, 2e-5f);
  }
}

TEST(ChainTest, ForcesBendTheBladeTheirWay) {
  Blade blade{};
  blade.height_m = 1.0f;
  blade.stiffness = 60.0f;
  const Curve rest = Kernels{}.pose_blade(blade, {0.0f, 0.0f}, 1.0f);
  Kernels::ChainVectors force;
  force.v1 = force.v2 = force.v3 = glm::vec3(0.0f, 0.0f, -1.0f);
  force.v4 = glm::vec3(0.5f, 0.0f, -1.0f);
  const Chain chain = Kernels{}.chain_under(blade, rest, 1.0f, force);
  EXPECT_GT(chain.p4.x, 0.02f);
  EXPECT_NEAR(chain.p4.y, 0.0f, 1e-4f);
  EXPECT_LT(chain.p4.z, 1.0f);
}

TEST(ChainTest, SplinePassesTheJointsAndIsSmoothThere) {
  std::mt19937 random(36);
  for (int n = 0; n < 500; ++n) {
    Blade blade = extreme_blade(random);
    blade.height_m = 1.0f;
    const Chain chain = hang(blade, slope(random, 0.8));
    const auto p = joints_of(chain);
    for (int i = 0; i <= 4; ++i) {
      ASSERT_LT(glm::distance(Kernels{}.chain_point(chain, 0.25f * static_cast<float>(i)), p[i]), 1e-6f);
    }
    for (const float u : {0.25f, 0.5f, 0.75f}) {
      const auto slope_at = [&](float v) { return glm::dvec3(Kernels{}.chain_derivative(chain, v)); };
      const float h = 1.0f / 256.0f;
      const glm::dvec3 before = slope_at(u - h), at = slope_at(u), after = slope_at(u + h);
      const glm::dvec3 rise = (point_on(chain, u + h) - point_on(chain, u - h)) * 128.0;
      ASSERT_LT(glm::distance(rise, at), 2e-3);
      ASSERT_LT(glm::distance(slope_at(u - 1e-6f), at), 1e-4) << "continuous slope";
      // Slopes are quadratic in u on each side: their derivatives at the joint, from three points.
      const glm::dvec3 bend_before = (3.0 * at - 4.0 * before + slope_at(u - 2.0f * h)) * 128.0;
      const glm::dvec3 bend_after = (-3.0 * at + 4.0 * after - slope_at(u + 2.0f * h)) * 128.0;
      ASSERT_LT(glm::distance(bend_before, bend_after), 5e-3) << "continuous curvature";
    }
  }
}

TEST(ChainTest, BlendsIntoTheHermiteBladeWithoutAJump) {
  std::mt19937 random(37);
  double moved = 0.0;
  for (int n = 0; n < 500; ++n) {
    Blade blade = extreme_blade(random);
    blade.root_m = {0.0f, 0.0f};
    blade.ground_m = 0.0f;
    const Chain chain = hang(blade, slope(random, 0.8));
    const Curve curve = Kernels{}.curve_of(chain);
    ASSERT_LE(relative_gap(Kernels{}.blended_chain(chain, 1.0f), curve, blade.height_m), 1e-5);
    ASSERT_EQ(curve.base_m, chain.p0);
    ASSERT_EQ(curve.tip_m, chain.p4);
    ASSERT_EQ(Kernels{}.blended_chain(chain, 0.0f).m2, chain.m2);
    ASSERT_EQ(Kernels{}.blended_chain(chain, 0.0f).p2, chain.p2);
    const double whole = relative_gap(chain, curve, blade.height_m);
    if (blade.stiffness >= 60.0f) moved = std::max(moved, whole);
    for (float share = 0.0f; share < 1.0f; share += 0.125f) {
      const Chain from = Kernels{}.blended_chain(chain, share);
      const Chain to = Kernels{}.blended_chain(chain, share + 0.125f);
      for (const float u : {0.1f, 0.3f, 0.5f, 0.6f, 0.9f, 1.0f}) {
        ASSERT_LE(glm::distance(point_on(from, u), point_on(to, u)) / static_cast<double>(blade.height_m),
                  0.125 * whole + 1e-4);
      }
    }
  }
  std::printf("spline and Hermite blade part by at most %.1f %% of the length\n", 100.0 * moved);
  EXPECT_LE(moved, 0.03);
}

TEST(ChainTest, TurnsWithItsBlade) {
  std::mt19937 random(38);
  for (int n = 0; n < 200; ++n) {
    Blade blade = extreme_blade(random);
    blade.root_m = {0.0f, 0.0f};
    blade.ground_m = 0.0f;
    blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 3.0));
    const glm::vec2 ground = slope(random, 0.8);
    const Chain chain = hang(blade, ground);
    const float by = static_cast<float>(uniform(random, 0.0, 3.0));
    const auto turned = [by](auto v) {
      auto result = v;
      result.x = std::cos(by) * v.x - std::sin(by) * v.y;
      result.y = std::sin(by) * v.x + std::cos(by) * v.y;
      return result;
    };
    blade.azimuth_rad += by;
    blade.lean = turned(blade.lean);
    const Chain other = hang(blade, turned(ground));
    ASSERT_LT(glm::distance(turned(chain.p4), other.p4) / blade.height_m, 1e-4f);
    ASSERT_LT(glm::distance(turned(chain.m2), other.m2) / blade.height_m, 1e-3f);
    ASSERT_LT(glm::distance(turned(chain.side), other.side), 1e-4f);
  }
}

TEST(ChainTest, HoldsForAnyBlade) {
  std::mt19937 random(39);
  for (int n = 0; n < 20000; ++n) {
    const Blade blade = extreme_blade(random);
    const float growth = n % 8 == 0   ? 0.0f
                         : n % 8 == 1 ? 1e-6f
                                      : static_cast<float>(uniform(random, 0.0, 1.0));
    const Chain chain = hang(blade, slope(random, 1.5), growth);
    const float reach_m = blade.height_m * growth;
    for (const float share : {0.0f, 0.5f, 1.0f}) {
      const Chain drawn = Kernels{}.blended_chain(chain, share);
      for (float u = 0.0f; u <= 1.0f; u += 0.125f) {
        const glm::vec3 p = Kernels{}.chain_point(drawn, u), m = Kernels{}.chain_derivative(drawn, u);
        ASSERT_LE(glm::distance(p, chain.p0), 1.05f * reach_m + 2e-6f);
        ASSERT_LE(glm::length(m), 2.0f * reach_m + 2e-5f);
      }
    }
    ASSERT_NEAR(glm::length(chain.side), 1.0f, 1e-5f);
    if (growth > 0.01f) {
      ASSERT_NEAR(glm::dot(chain.side, glm::normalize(chain.m0)), 0.0f, 1e-4f);
      ASSERT_GT(glm::length(chain.m4), 0.9f * reach_m);
    }
  }
}

}  // namespace
}  // namespace prairie
