#include "animation/handover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/inertial_chains.h"
#include "animation/virtual_blades.h"
#include "chain_cases.h"

namespace prairie {
namespace {

constexpr float kStep = 1.0f / 60.0f;

TEST(HandoverTest, TouchedBladesReturnToTheirVirtualOnesWithoutAJump) {
  std::mt19937 random(4);
  const ChainTraits traits{0.04f, 60.0f, 0.2f, 0.2f};
  constexpr std::size_t kBlades = 200;
  VirtualBlades window({traits}, 4, 1.0, {0.0, 0.0});
  InertialChains chains(kBlades);
  for (std::size_t n = 0; n < kBlades; ++n) {
    chains.plant(
        n,
        chain_vectors(
            leaning_arc(uniform(random, 0.0, 0.5), uniform(random, 0.0, 6.28), 0.6, 1.0).directions()),
        traits);
    const glm::vec3 push(unit_vector(random) * 1.2);
    chains.set_motion(n, {{push, push, push, push}, {}});
  }
  std::vector<SpentMotion> watch(kBlades);
  std::vector<bool> returned(kBlades, false);
  std::vector<ChainVectors> offset(kBlades);
  std::size_t left = kBlades;
  float jump = 0.0f, end = 0.0f;
  for (int step = 0; step < 900; ++step) {
    const glm::vec3 wind(2.0f + std::sin(0.02f * static_cast<float>(step)), 0.5f, 0.0f);
    window.step(std::vector<glm::vec3>(window.texel_count(), wind), kStep);
    for (std::size_t n = 0; n < kBlades; ++n) chains.set_wind(n, wind);
    chains.step(kStep);
    const auto [a, b, c, d] = window.at(0, {0.2, 0.3}).segments;
    const ChainVectors load = Kernels{}.texel_load(a, b, c, d);
    end = 0.0f;
    for (std::size_t n = 0; n < kBlades; ++n) {
      const ChainVectors rest = chains.rest(n),
                         turn = Kernels{}.virtual_turns(rest, load, 1.0f / traits.stiffness);
      if (!returned[n]) {
        const ChainVectors now = chains.motion(n).turn;
        if (watch[n].watch(tip_gap(rest, now, turn))) {
          returned[n] = true;
          --left;
          offset[n] = Kernels{}.chain_sum(now, turn, -1.0f);
        }
        continue;
      }
      const ChainVectors before = Kernels{}.chain_sum(turn, offset[n], 1.0f);
      offset[n] = faded(offset[n], 0.005f);
      const ChainVectors after = Kernels{}.chain_sum(turn, offset[n], 1.0f);
      jump = std::max(jump, tip_gap(rest, before, after));
      end = std::max(end, tip_gap(rest, after, turn));
    }
  }
  std::printf("%zu of %zu blades still inertial; returning moves tips by at most %.2f %% a frame\n", left,
              kBlades, 100.0 * static_cast<double>(jump));
  EXPECT_EQ(left, 0u);
  EXPECT_LE(jump, 0.01f);
  EXPECT_EQ(end, 0.0f);
}

}  // namespace
}  // namespace prairie
