// Blades that objects touch: none is inside them, and all rise again.
#include "animation/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "chain_cases.h"

namespace prairie {
namespace {

constexpr float kStep = 1.0f / 60.0f;
const glm::vec3 kUp(0.0f, 0.0f, 1.0f);

Blade meadow_blade(std::mt19937& random, glm::vec2 root_m) {
  Blade blade{};
  blade.root_m = root_m;
  blade.height_m = static_cast<float>(uniform(random, 0.1, 0.5));
  blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 6.28));
  blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 0.3));
  blade.curvature_rad = static_cast<float>(uniform(random, 0.2, 1.2));
  blade.stiffness = static_cast<float>(uniform(random, 50.0, 120.0));
  return blade;
}

struct Found {
  double deepest_m = 0.0;
  double highest_m = 0.0;
};

Found look(const Solid& solid, const Kernels::BladeChain& chain) {
  Found found;
  for (int n = 0; n <= 400; ++n) {
    const glm::dvec3 point(Kernels{}.chain_point(chain, static_cast<float>(n) / 400.0f));
    found.deepest_m = std::max(found.deepest_m, -separation(solid, point).distance_m);
    found.highest_m = std::max(found.highest_m, point.z);
  }
  return found;
}

TEST(ContactTest, SeparationIsADistance) {
  std::mt19937 random(1);
  const glm::dmat3 axes(glm::dvec3(0.8, 0.6, 0.0), glm::dvec3(-0.6, 0.8, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  for (const Solid& solid :
       {Solid(Sphere{{0.1, 0.2, 0.3}, 0.5}), Solid(Capsule{{0.0, 0.0, 0.0}, {1.0, 0.5, 0.2}, 0.3}),
        Solid(Box{{0.2, 0.1, 0.3}, axes, {0.5, 0.3, 0.2}})}) {
    for (int n = 0; n < 5000; ++n) {
      const glm::dvec3 p = unit_vector(random) * uniform(random, 0.0, 2.0);
      const Separation at = separation(solid, p);
      ASSERT_NEAR(glm::length(at.outward), 1.0, 1e-12);
      ASSERT_NEAR(separation(solid, p + at.outward * 1e-6).distance_m, at.distance_m + 1e-6, 1e-9);
      if (at.distance_m > 0.0) {
        ASSERT_NEAR(separation(solid, p - at.outward * at.distance_m).distance_m, 0.0, 1e-12);
      }
    }
  }
}

TEST(ContactTest, NoPointOfADrawnBladeIsInside) {
  std::mt19937 random(2);
  const double c = std::cos(0.4), s = std::sin(0.4);
  const glm::dmat3 axes(glm::dvec3(c, s, 0.0), glm::dvec3(-s, c, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  const Solid solids[] = {Sphere{{0.0, 0.0, 0.3}, 0.3}, Sphere{{0.0, 0.0, 0.08}, 0.08},
                          Capsule{{-0.4, 0.0, 0.1}, {0.4, 0.1, 0.25}, 0.1},
                          Box{{0.0, 0.0, 0.15}, axes, {0.3, 0.2, 0.15}}};
  double deepest_m = 0.0, highest_m = 0.0;
  int touched = 0, laid = 0;
  for (const Solid& solid : solids) {
    for (int n = 0; n < 20000; ++n) {
      const glm::vec2 root_m(static_cast<float>(uniform(random, -0.6, 0.6)),
                             static_cast<float>(uniform(random, -0.6, 0.6)));
      const Blade blade = meadow_blade(random, root_m);
      const auto rest = Kernels{}.pose_blade(blade, {0.0f, 0.0f}, 1.0f);
      ChainMotion motion{};
      motion.rate.v2 = glm::vec3(1.0f, 2.0f, 0.0f);
      if (!bend_out(solid, blade, rest, 1.0f, kUp, motion)) {
        EXPECT_LE(look(solid, Kernels{}.turned_chain(blade, rest, 1.0f, motion.turn)).deepest_m, 1e-3);
        continue;
      }
      ++touched;
      EXPECT_EQ(motion.rate.v2, glm::vec3(0.0f));
      const Found found = look(solid, Kernels{}.turned_chain(blade, rest, 1.0f, motion.turn));
      const bool under = separation(solid, glm::dvec3(rest.base_m)).distance_m < 2e-3;
      if (under) {
        ++laid;
        highest_m = std::max(highest_m, found.highest_m);
      } else {
        deepest_m = std::max(deepest_m, found.deepest_m);
        EXPECT_LE(found.deepest_m, 1e-3) << "root " << root_m.x << ' ' << root_m.y << " length "
                                         << blade.height_m << " solid " << &solid - solids;
      }
    }
  }
  std::printf("%d touched: at most %.2f mm inside; %d laid down: at most %.2f mm high\n", touched,
              1e3 * deepest_m, laid, 1e3 * highest_m);
  EXPECT_LE(highest_m, 5e-3);
  EXPECT_GT(touched, 8000);
}

TEST(ContactTest, ARollingSphereLeavesNoBladeBehind) {
  std::mt19937 random(3);
  constexpr std::size_t kBlades = 10000;
  std::vector<Blade> blades;
  std::vector<Kernels::BladeCurve> rests;
  InertialChains chains(kBlades);
  for (std::size_t n = 0; n < kBlades; ++n) {
    blades.push_back(meadow_blade(random, {static_cast<float>(uniform(random, 0.0, 4.0)),
                                           static_cast<float>(uniform(random, -0.6, 0.6))}));
    rests.push_back(Kernels{}.pose_blade(blades[n], {0.0f, 0.0f}, 1.0f));
    chains.plant(n, Kernels{}.chain_rest(rests[n]).along,
                 {blades[n].height_m / 8.0f, blades[n].stiffness, 0.25f, 0.2f});
  }
  for (int step = 0; step < 120; ++step) chains.step(kStep);
  std::vector<ChainVectors> before;
  for (std::size_t n = 0; n < kBlades; ++n) before.push_back(chains.directions(n));
  std::size_t touched = 0, inside = 0;
  double deepest_m = 0.0;
  for (int step = 0; step < 210; ++step) {
    const Sphere sphere{{-0.7 + 1.6 * step / 60.0, 0.0, 0.25}, 0.25};
    chains.step(kStep);
    for (std::size_t n = 0; n < kBlades; ++n) {
      ChainMotion motion = chains.motion(n);
      if (!bend_out(sphere, blades[n], rests[n], 1.0f, kUp, motion)) continue;
      ++touched;
      chains.set_motion(n, motion);
      if (separation(sphere, glm::dvec3(rests[n].base_m)).distance_m < 2e-3) continue;
      const Found found = look(sphere, Kernels{}.turned_chain(blades[n], rests[n], 1.0f, motion.turn));
      deepest_m = std::max(deepest_m, found.deepest_m);
      inside += found.deepest_m > 1e-3;
    }
  }
  for (int step = 0; step < 300; ++step) chains.step(kStep);
  double off = 0.0;
  for (std::size_t n = 0; n < kBlades; ++n) {
    off = std::max(off, glm::distance(tip_share(chains.directions(n)), tip_share(before[n])));
  }
  std::printf(
      "%zu contacts, at most %.2f mm deep, %zu too deep; five seconds later tips are within %.2f %%\n",
      touched, 1e3 * deepest_m, inside, 100.0 * off);
  EXPECT_EQ(inside, 0u);
  EXPECT_LE(off, 0.01);
}

}  // namespace
}  // namespace prairie
