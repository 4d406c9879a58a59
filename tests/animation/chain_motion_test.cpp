// Inertial blades: where they come to rest, how they swing, what energy they have, and that they outlive
// anything.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "animation/inertial_chains.h"
#include "articulated_chain.h"
#include "chain_cases.h"

namespace prairie {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr float kStep = 1.0f / 60.0f;

glm::dvec3 resting_tip(const Arc& arc, double stiffness) {
  InertialChains chains(1);
  chains.plant(0, chain_vectors(arc.directions()), {0.04f, static_cast<float>(stiffness), 0.5f, 0.0f});
  for (int n = 0; n < 900; ++n) chains.step(kStep);
  return tip_share(chains.directions(0));
}

glm::dvec3 reference_tip(const Arc& arc, double stiffness) {
  ArticulatedChain chain(arc.foot, arc.axis, arc.turning, stiffness);
  chain.settle();
  EXPECT_LT(chain.fastest(), 1e-4);
  return chain.tip() * 0.125;
}

/// B11's simplified chain, in a plane: κ ψ_i = sin φ_i, φ being segments' angles from the vertical.
glm::dvec3 simplified_tip(double lean_rad, double stiffness) {
  double below = lean_rad;
  glm::dvec3 tip(0.0);
  for (int i = 0; i < 4; ++i) {
    const double k = i == 0 ? 2.0 * stiffness : stiffness;
    double angle = below;
    for (int n = 0; n < 200; ++n) angle = below + std::sin(angle) / k;
    tip += glm::dvec3(std::sin(angle), 0.0, std::cos(angle)) * 0.25;
    below = angle;
  }
  return tip;
}

TEST(ChainMotionTest, RestsWhereTheArticulatedChainDoes) {
  double most = 0.0;
  for (const double stiffness : {60.0, 120.0, 1000.0, 1e4}) {
    double worst = 0.0;
    for (const double lean_deg : {0.0, 10.0, 20.0, 30.0, 45.0}) {
      for (const double turning : {0.0, 0.8}) {
        for (const double bend : {0.0, 1.2}) {
          if (turning == 0.0 && bend > 0.0) continue;
          const Arc arc = leaning_arc(lean_deg * kRadPerDeg, 0.7, turning, bend);
          const double error = glm::distance(resting_tip(arc, stiffness), reference_tip(arc, stiffness));
          worst = std::max(worst, error);
        }
      }
    }
    std::printf("stiffness %5.0f: tip within %.3f %% of the length of the reference's\n", stiffness,
                100.0 * worst);
    most = std::max(most, worst);
  }
  EXPECT_LE(most, 0.02);
}

TEST(ChainMotionTest, SimplifiedChainNeedsCalibrationAndStaysBehindEvenThen) {
  const double stiffness = 60.0;
  const auto wanted = [&](double deg) {
    return reference_tip(leaning_arc(deg * kRadPerDeg, 0.0, 0.0, 0.0), stiffness);
  };
  const auto sag = [](const glm::dvec3& tip, double deg) {
    return glm::distance(tip, glm::dvec3(std::sin(deg * kRadPerDeg), 0.0, std::cos(deg * kRadPerDeg)));
  };
  const glm::dvec3 at20 = wanted(20.0);
  double low = 1.0, high = stiffness;  // by halving, to the same sag at 20°
  for (int n = 0; n < 60; ++n) {
    const double mid = 0.5 * (low + high);
    (sag(simplified_tip(20.0 * kRadPerDeg, mid), 20.0) > sag(at20, 20.0) ? low : high) = mid;
  }
  const double ratio = sag(at20, 20.0) / sag(simplified_tip(20.0 * kRadPerDeg, stiffness), 20.0);
  std::printf("equal springs: 1/%.0f of the sag; agrees at 20 degrees with springs of %.2f instead of %.0f\n",
              ratio, low, stiffness);
  double simplified = 0.0, ours = 0.0;
  for (const double deg : {5.0, 10.0, 30.0, 45.0}) {
    const glm::dvec3 exact = wanted(deg);
    simplified = std::max(simplified, glm::distance(simplified_tip(deg * kRadPerDeg, low), exact));
    ours = std::max(
        ours, glm::distance(resting_tip(leaning_arc(deg * kRadPerDeg, 0.0, 0.0, 0.0), stiffness), exact));
  }
  std::printf("0 to 45 degrees: simplified, calibrated %.2f %%; here %.3f %% of the length\n",
              100.0 * simplified, 100.0 * ours);
  EXPECT_GT(ratio, 5.0);
  EXPECT_LE(ours, simplified);
}

TEST(ChainMotionTest, SwingsAsTheArticulatedChainDoes) {
  for (const double lean_deg : {0.0, 30.0}) {
    const Arc arc = leaning_arc(lean_deg * kRadPerDeg, 0.4, 0.6, 0.0);
    const double stiffness = 80.0;
    ArticulatedChain reference(arc.foot, arc.axis, arc.turning, stiffness);
    reference.settle();
    reference.medium = 0.0;
    const glm::dvec3 push = glm::normalize(glm::dvec3(0.3, 1.0, 0.0)) * 0.35;
    InertialChains chains(1);
    chains.plant(0, chain_vectors(arc.directions()), {0.04f, static_cast<float>(stiffness), 0.5f, 0.0f});
    for (int n = 0; n < 900; ++n) chains.step(kStep);
    ChainTraits undamped = chains.traits(0);
    undamped.damping_ratio = 0.0f;
    ChainMotion motion = chains.motion(0);
    chains.plant(0, chains.rest(0), undamped);
    const auto shares = {0.31527805, 0.72771214, 0.93954949, 1.0};  // the lowest mode
    std::array<glm::dvec3, 4> pushes;
    std::transform(shares.begin(), shares.end(), pushes.begin(), [&](double s) { return push * s; });
    reference.turn(pushes);
    motion.turn = Kernels{}.chain_sum(motion.turn, chain_vectors(pushes), 1.0f);
    chains.set_motion(0, motion);
    const double unit_s = std::sqrt(0.04 / 9.81), dt = static_cast<double>(kStep) / unit_s;
    double squares = 0.0, swing = 0.0;
    const glm::dvec3 start = reference.tip() * 0.125;
    const int kSteps = 60;
    for (int n = 0; n < kSteps; ++n) {
      for (int s = 0; s < 40; ++s) reference.step(dt / 40.0);
      chains.step(kStep);
      const glm::dvec3 gap = tip_share(chains.directions(0)) - reference.tip() * 0.125;
      squares += glm::dot(gap, gap);
      swing = std::max(swing, glm::distance(reference.tip() * 0.125, start));
    }
    const double rms = std::sqrt(squares / kSteps);
    std::printf("lean %2.0f: a second of free swing over %.0f %% of the length, tip %.2f %% rms off\n",
                lean_deg, 100.0 * swing, 100.0 * rms);
    EXPECT_LT(rms, 0.2 * swing) << "more than their periods differ";
  }
}

TEST(ChainMotionTest, FreeEnergyNeverExceedsItsStart) {
  std::mt19937 random(11);
  constexpr std::size_t kChains = 5000;
  InertialChains chains(kChains);
  std::vector<double> start(kChains), floor(kChains);
  for (std::size_t n = 0; n < kChains; ++n) {
    const Arc arc = leaning_arc(uniform(random, 0.0, 0.8), uniform(random, 0.0, 6.28),
                                uniform(random, 0.0, 1.5), uniform(random, 0.0, 6.28));
    const ChainVectors rest = chain_vectors(arc.directions());
    const ChainTraits traits{static_cast<float>(log_uniform(random, 0.003, 0.25)),
                             static_cast<float>(log_uniform(random, 10.0, 1e4)),
                             static_cast<float>(uniform(random, 0.15, 1.0)),
                             static_cast<float>(n % 2 == 0 ? 0.0 : log_uniform(random, 0.01, 1.0))};
    chains.plant(n, rest, traits);
    ChainMotion motion{};
    std::array<glm::dvec3, 4> turn, rate;
    const double most = uniform(random, 0.0, 1.2), fastest = uniform(random, 0.0, 20.0);
    for (int i = 0; i < 4; ++i) {
      turn[i] =
          unit_vector(random) * uniform(random, 0.0, most) + (i > 0 ? turn[i - 1] : glm::dvec3(0.0)) * 0.6;
      rate[i] = unit_vector(random) * uniform(random, 0.0, fastest);
    }
    motion.turn = chain_vectors(turn);
    motion.rate = chain_vectors(rate);
    chains.set_motion(n, motion);
    start[n] = energy_of(rest, motion, traits);
  }
  double excess = 0.0;
  std::vector<double> peak(kChains, -1e30);
  for (int step = 0; step < 600; ++step) {
    chains.step(kStep);
    for (std::size_t n = 0; n < kChains; ++n) {
      peak[n] = std::max(peak[n], energy_of(chains.rest(n), chains.motion(n), chains.traits(n)));
    }
  }
  int above = 0;
  for (std::size_t n = 0; n < kChains; ++n) {
    const double end = energy_of(chains.rest(n), chains.motion(n), chains.traits(n));
    const double most = (peak[n] - start[n]) / std::max(start[n] - end, 1e-3);
    above += most > 1e-4;
    excess = std::max(excess, most);
  }
  std::printf("%d of %zu chains rise above their start, by at most %.4f of what they lose\n", above, kChains,
              excess);
  EXPECT_LE(excess, 1e-4);
}

/// How many of `count` random blades in changing wind are not blades any more after 10 s.
std::size_t lost_blades(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  constexpr std::size_t kBatch = 20000;
  std::size_t lost = 0;
  for (std::size_t done = 0; done < count; done += kBatch) {
    InertialChains chains(std::min(kBatch, count - done));
    const auto blow = [&](bool calm) {
      for (std::size_t n = 0; n < chains.size(); ++n) {
        const double speed = calm && n % 2 == 0 ? 0.0 : log_uniform(random, 0.01, 60.0);
        chains.set_wind(n, glm::vec3(unit_vector(random) * speed));
      }
    };
    for (std::size_t n = 0; n < chains.size(); ++n) {
      const Arc arc = leaning_arc(uniform(random, 0.0, 1.48), uniform(random, 0.0, 6.28),
                                  uniform(random, 0.0, 2.97), uniform(random, 0.0, 6.28));
      chains.plant(n, chain_vectors(arc.directions()), any_traits(random));
      std::array<glm::dvec3, 4> turn, rate;
      for (int i = 0; i < 4; ++i) {
        turn[i] = unit_vector(random) * uniform(random, 0.0, std::numbers::pi);
        rate[i] = unit_vector(random) * uniform(random, 0.0, 50.0);
      }
      chains.set_motion(n, {chain_vectors(turn), chain_vectors(rate)});
    }
    for (int step = 0; step < 600; ++step) {
      if (step % 150 == 0) blow(step == 300);
      chains.step(kStep);
    }
    for (std::size_t n = 0; n < chains.size(); ++n) {
      const ChainMotion motion = chains.motion(n);
      double turn2 = 0.0, rate2 = 0.0;
      for (const auto& v : vectors_of(motion.turn)) turn2 = std::max(turn2, glm::dot(v, v));
      for (const auto& v : vectors_of(motion.rate)) rate2 = std::max(rate2, glm::dot(v, v));
      const bool fine =
          turn2 <= 9.8697 && rate2 < 1e6 && std::abs(glm::length(chains.directions(n).v4) - 1.0f) < 1e-3f;
      lost += !fine;
    }
  }
  return lost;
}

TEST(ChainMotionTest, OutlivesAnythingThatAScenePlants) {
  EXPECT_EQ(lost_blades(100000, 1), 0u);
}

TEST(ChainMotionLongTest, OutlivesAMillionScenes) {
  EXPECT_EQ(lost_blades(1000000, 2), 0u);
}

}  // namespace
}  // namespace prairie
