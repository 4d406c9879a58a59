// The reference is itself held to what it must conserve and where it must come to rest.
#include "articulated_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace prairie {
namespace {

TEST(ArticulatedChainTest, ConservesEnergyWithoutFriction) {
  ArticulatedChain chain({0.2, 0.1, 0.97},
                         glm::normalize(glm::cross(glm::dvec3(0.2, 0.1, 0.97), {0.0, 1.0, 0.0})), 0.8, 60.0);
  chain.turn({glm::dvec3(0.1, 0.0, 0.0), {0.3, 0.2, 0.0}, {0.4, 0.5, 0.1}, {0.2, 0.9, -0.1}});
  const double before = chain.energy();
  double most = 0.0;
  for (int n = 0; n < 20000; ++n) {
    chain.step(0.002);
    most = std::max(most, std::abs(chain.energy() - before));
  }
  EXPECT_LT(most, 1e-5 * 60.0);
  EXPECT_GT(chain.fastest(), 0.1);
}

TEST(ArticulatedChainTest, StiffChainHasTheFrequencyOfItsLowestMode) {
  // Least eigenvalue of B x = λ A x for straight chains (docs/chains.md): ω² = 0.0114092 κ.
  const double stiffness = 1e5;
  ArticulatedChain chain({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.0, stiffness);
  const auto mode = [](double share) { return glm::dvec3(0.01 * share, 0.0, 0.0); };
  chain.turn({mode(0.31527805), mode(0.72771214), mode(0.93954949), mode(1.0)});
  const double dt = 1e-4, from = chain.tip().y;
  int steps = 0;
  while (chain.tip().y * from > 0.0 && steps < 100000) {
    chain.step(dt);
    ++steps;
  }
  EXPECT_NEAR(steps * dt, 0.5 * 3.14159265 / std::sqrt(0.0114091729 * stiffness), 2e-4);
}

}  // namespace
}  // namespace prairie
