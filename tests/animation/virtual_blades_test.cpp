// Virtually-inertial blades against inertial ones in the same wind, and the window that follows the camera.
#include "animation/virtual_blades.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "chain_cases.h"

namespace prairie {
namespace {

constexpr float kStep = 1.0f / 60.0f;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;

/// Gusts of 5 to 25 m that the mean wind carries along, from calm to twice the mean.
glm::vec3 gusts(double mean_m_per_s, glm::dvec2 at_m, double time_s) {
  double along = 0.0, across = 0.0;
  for (int m = 0; m < 6; ++m) {
    const double k = 2.0 * std::numbers::pi / (5.0 + 4.0 * m);
    const double phase =
        k * (std::cos(1.0 * m) * at_m.x + std::sin(1.0 * m) * at_m.y - mean_m_per_s * time_s) + 2.1 * m;
    along += 0.15 * std::sin(phase);
    across += 0.15 * std::sin(phase * 0.8 + m);
  }
  return glm::vec3(mean_m_per_s * glm::dvec3(1.0 + along, across, 0.1 * across));
}

struct Errors {
  double at_texel = 0.0;
  double leaning = 0.0;  // straight blades between texels
  double curved = 0.0;   // the same with an arc of their own
  double deflection = 0.0;
};

/// Root mean squares over 10 s of the distance of tips, as shares of the blades' length.
Errors compare(const ChainTraits& traits, double mean_m_per_s) {
  constexpr int kSide = 12;
  constexpr std::size_t kBlades = 128;
  VirtualBlades blades({traits}, kSide, 1.0, {0.0, 0.0});
  InertialChains chains(kBlades);
  std::vector<glm::dvec2> place(kBlades);
  std::mt19937 random(5);
  for (std::size_t n = 0; n < kBlades; ++n) {
    Arc arc;
    place[n] = blades.middle_m(40 + n % 8);
    if (n >= kBlades / 2) {
      place[n] = {uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0)};
      const double curvature = n % 2 == 0 ? 0.0 : uniform(random, 0.3, 1.2);
      arc = leaning_arc(uniform(random, 0.0, 30.0) * kRadPerDeg, uniform(random, 0.0, 6.28), curvature,
                        uniform(random, 0.0, 6.28));
    }
    chains.plant(n, chain_vectors(arc.directions()), traits);
  }
  Errors errors;
  std::array<double, 3> count{};
  const auto blow = [&](double time_s) {
    std::vector<glm::vec3> wind(blades.texel_count());
    for (std::size_t n = 0; n < wind.size(); ++n) wind[n] = gusts(mean_m_per_s, blades.middle_m(n), time_s);
    blades.step(wind, kStep);
    for (std::size_t n = 0; n < kBlades; ++n) chains.set_wind(n, gusts(mean_m_per_s, place[n], time_s));
    chains.step(kStep);
  };
  for (int step = 0; step < 120; ++step) blow(step / 60.0);
  for (int step = 120; step < 720; ++step) {
    blow(step / 60.0);
    for (std::size_t n = 0; n < kBlades; ++n) {
      const auto [a, b, c, d] = blades.at(0, place[n]).segments;
      const ChainVectors rest = chains.rest(n);
      const ChainVectors turn =
          Kernels{}.virtual_turns(rest, Kernels{}.texel_load(a, b, c, d), 1.0f / traits.stiffness);
      const glm::dvec3 gap =
          tip_share(Kernels{}.chain_directions(rest, turn)) - tip_share(chains.directions(n));
      const int kind = n < kBlades / 2 ? 0 : n % 2 == 0 ? 1 : 2;
      double& sum = kind == 0 ? errors.at_texel : kind == 1 ? errors.leaning : errors.curved;
      sum += glm::dot(gap, gap);
      count[kind] += 1.0;
      if (kind == 0) {
        const glm::dvec3 moved = tip_share(chains.directions(n)) - glm::dvec3(0.0, 0.0, 1.0);
        errors.deflection += glm::dot(moved, moved);
      }
    }
  }
  errors.at_texel = std::sqrt(errors.at_texel / count[0]);
  errors.deflection = std::sqrt(errors.deflection / count[0]);
  errors.leaning = std::sqrt(errors.leaning / count[1]);
  errors.curved = std::sqrt(errors.curved / count[2]);
  return errors;
}

TEST(VirtualBladesTest, MoveAsInertialBladesDo) {
  Errors most;
  for (const float length_m : {0.1f, 0.32f, 0.8f}) {
    for (const float drag : {0.1f, 0.3f, 1.0f}) {
      for (const double wind : {2.0, 5.0}) {
        const Errors e = compare({length_m / 8.0f, 60.0f, 0.2f, drag}, wind);
        std::printf(
            "%.2f m, drag %.1f, %.0f m/s: tip moves by %2.0f %% rms; off by %.2f %% at texels, %.2f %% "
            "leaning "
            "between them, %.2f %% curved\n",
            static_cast<double>(length_m), static_cast<double>(drag), wind, 100.0 * e.deflection,
            100.0 * e.at_texel, 100.0 * e.leaning, 100.0 * e.curved);
        most.at_texel = std::max(most.at_texel, e.at_texel);
        most.leaning = std::max(most.leaning, e.leaning);
        most.curved = std::max(most.curved, e.curved);
      }
    }
  }
  EXPECT_LE(most.at_texel, 0.05);
  EXPECT_LE(most.leaning, 0.05);
  EXPECT_LE(most.curved, 0.08);
}

TEST(VirtualBladesTest, DrawnBladesRestInCalmAirWhereTheyDidWithoutWind) {
  std::mt19937 random(6);
  double drawn = 0.0, inertial = 0.0;
  Kernels kernels;
  ChainVectors none{};
  for (int n = 0; n < 500; ++n) {
    Blade blade{};
    blade.height_m = 0.4f;
    blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 6.28));
    blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 0.5));
    blade.curvature_rad = static_cast<float>(uniform(random, 0.0, 1.2));
    blade.lean = {static_cast<float>(uniform(random, -0.3, 0.3)),
                  static_cast<float>(uniform(random, -0.3, 0.3))};
    blade.stiffness = static_cast<float>(log_uniform(random, 60.0, 1000.0));
    const auto rest = kernels.pose_blade(blade, {0.0f, 0.0f}, 1.0f);
    const auto moved = kernels.virtual_pose(blade, rest, 1.0f, none);
    const auto still = kernels.chain_of(blade, rest, 1.0f);
    drawn = std::max(drawn, static_cast<double>(glm::distance(moved.p4, still.p4) / blade.height_m));
    InertialChains chain(1);
    chain.plant(0, kernels.chain_rest(rest).along, {0.05f, blade.stiffness, 0.7f, 0.0f});
    for (int step = 0; step < 300; ++step) chain.step(kStep);
    const ChainVectors turn = kernels.virtual_turns(chain.rest(0), none, 1.0f / blade.stiffness);
    inertial = std::max(inertial, glm::distance(tip_share(kernels.chain_directions(chain.rest(0), turn)),
                                                tip_share(chain.directions(0))));
  }
  std::printf("calm: virtual within %.2f %% of the still blade and %.2f %% of the inertial one\n",
              100.0 * drawn, 100.0 * inertial);
  EXPECT_LE(drawn, 0.006);
  EXPECT_LE(inertial, 0.005);
}

TEST(VirtualBladesTest, BladesThatAreBentSidewaysKeepTheirBreadth) {
  Kernels kernels;
  for (int n = 0; n < 36; ++n) {
    Blade blade{};
    blade.height_m = 0.4f;
    blade.curvature_rad = 0.5f;
    blade.stiffness = 60.0f;
    blade.azimuth_rad = static_cast<float>(10.0 * n * kRadPerDeg);
    const auto rest = kernels.pose_blade(blade, {0.0f, 0.0f}, 1.0f);
    const glm::vec3 wind(0.08f, 0.0f, 0.0f);
    const auto chain = kernels.virtual_pose(blade, rest, 1.0f, {wind * 7.0f, wind * 5.0f, wind * 3.0f, wind});
    EXPECT_GT(chain.p4.x, 0.6f * blade.height_m) << "bent far";
    EXPECT_NEAR(glm::length(chain.side), 1.0f, 1e-4f);
    for (int i = 0; i <= 20; ++i) {
      const glm::vec3 along = glm::normalize(kernels.chain_derivative(chain, 0.05f * static_cast<float>(i)));
      EXPECT_LT(std::abs(glm::dot(along, chain.side)), 0.9f);
    }
  }
}

TEST(VirtualBladesTest, AnyLoadLeavesABlade) {
  std::mt19937 random(7);
  Kernels kernels;
  for (int n = 0; n < 100000; ++n) {
    const auto vector = [&] { return glm::vec3(unit_vector(random) * log_uniform(random, 1e-6, 1e6)); };
    const Arc arc =
        leaning_arc(uniform(random, 0.0, 1.48), uniform(random, 0.0, 6.28), uniform(random, 0.0, 2.97), 1.0);
    const ChainVectors rest = chain_vectors(arc.directions());
    const ChainVectors turn = kernels.virtual_turns(rest, {vector(), vector(), vector(), vector()},
                                                    static_cast<float>(uniform(random, 0.0, 0.05)));
    const ChainVectors along = kernels.chain_directions(rest, turn);
    for (const auto& t : vectors_of(along)) ASSERT_NEAR(glm::length(t), 1.0, 1e-4);
  }
}

TEST(VirtualBladesTest, WindowFollowsTheEyeAndKeepsWhatItHolds) {
  const ChainTraits traits{0.04f, 60.0f, 0.2f, 0.3f};
  VirtualBlades blades({traits}, 8, 0.5, {100.2, -40.1});
  std::vector<glm::vec3> wind(blades.texel_count());
  const auto blow = [&](int steps) {
    for (int n = 0; n < steps; ++n) {
      for (std::size_t i = 0; i < wind.size(); ++i) wind[i] = gusts(3.0, blades.middle_m(i), 0.0);
      blades.step(wind, kStep);
    }
  };
  blow(300);
  std::vector<glm::dvec2> middles;
  for (std::size_t n = 0; n < blades.texel_count(); ++n) {
    const glm::dvec2 middle = blades.middle_m(n);
    middles.push_back(middle);
    EXPECT_LE(std::abs(middle.x - 100.2), 2.25);
    EXPECT_LE(std::abs(middle.y + 40.1), 2.25);
    // In the middle of a texel it is sampled alone.
    EXPECT_EQ(blades.at(0, middle).segments[2], blades.texels(0)[n].segments[2]);
  }
  const std::vector<VirtualTexel> before(blades.texels(0).begin(), blades.texels(0).end());
  blades.follow({101.2, -40.6});
  std::size_t kept = 0;
  for (std::size_t n = 0; n < blades.texel_count(); ++n) {
    const bool stays = blades.middle_m(n) == middles[n];
    kept += stays;
    if (stays) {
      EXPECT_EQ(blades.texels(0)[n].segments[0], before[n].segments[0]);
    }
    EXPECT_NE(blades.texels(0)[n].segments[0], glm::vec4(0.0f)) << "new texels move as their neighbours";
  }
  EXPECT_EQ(kept, 6u * 7u);
  blow(300);
  // The tip leans with the wind.
  for (const VirtualTexel& texel : blades.texels(0)) {
    EXPECT_GT(texel.segments[0].w, 0.02f);
    EXPECT_LT(texel.segments[2].w, 0.0f);
  }
  blades.follow({5000.0, 5000.0});
  EXPECT_EQ(blades.texels(0)[0].segments[0], glm::vec4(0.0f));
}

TEST(VirtualBladesTest, StepsAreThoseOfTheKernelForAnyNumberOfThreads) {
  std::mt19937 random(8);
  InertialChains one(1000), many(1000);
  for (std::size_t n = 0; n < one.size(); ++n) {
    const ChainVectors rest =
        chain_vectors(leaning_arc(0.3, uniform(random, 0.0, 6.28), 0.8, 1.0).directions());
    const ChainTraits traits = any_traits(random);
    for (InertialChains* chains : {&one, &many}) chains->plant(n, rest, traits);
    const glm::vec3 wind(unit_vector(random) * uniform(random, 0.0, 10.0));
    for (InertialChains* chains : {&one, &many}) chains->set_wind(n, wind);
  }
  std::vector<ChainMotion> alone(one.size());
  for (int step = 0; step < 20; ++step) {
    for (std::size_t n = 0; n < one.size(); ++n) {
      alone[n] = Kernels{}.chain_after(one.motion(n), one.rest(n), one.traits(n), one.wind_m_per_s(n), kStep);
    }
    {
      tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
      one.step(kStep);
    }
    many.step(kStep);
    for (std::size_t n = 0; n < one.size(); ++n) {
      const ChainMotion a = one.motion(n), b = many.motion(n);
      ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0);
      ASSERT_EQ(std::memcmp(&a, &alone[n], sizeof a), 0);
    }
  }
}

}  // namespace
}  // namespace prairie
