#include <cmath>
#include <vector>

#include "animation/inertial_chains.h"
#include "animation/virtual_blades.h"
#include "bench/benches.h"
#include "bench/timing.h"

namespace prairie {
namespace {

constexpr float kStepS = 1.0f / 60.0f;
constexpr int kSteps = 120;
constexpr std::size_t kInertialBlades = 100'000;
constexpr int kVirtualSide = 64;
constexpr ChainTraits kMeadowBlade{0.04f, 60.0f, 0.2f, 0.3f};

// A breeze that differs from blade to blade and from step to step.
glm::vec3 breeze(std::size_t blade, int step) {
  const float phase = 0.37f * static_cast<float>(blade % 1000) + 0.05f * static_cast<float>(step);
  return {2.0f + std::sin(phase), 0.5f * std::cos(phase), 0.0f};
}

double inertial_step_ms() {
  InertialChains blades(kInertialBlades);
  for (std::size_t n = 0; n < blades.size(); ++n) blades.plant(n, blades.rest(n), kMeadowBlade);
  return median_ms(kSteps, [&](int step) {
    for (std::size_t n = 0; n < blades.size(); ++n) blades.set_wind(n, breeze(n, step));
    return elapsed_ms([&] { blades.step(kStepS); });
  });
}

double virtual_step_ms() {
  VirtualBlades blades({kMeadowBlade}, kVirtualSide, 1.0, {0.0, 0.0});
  std::vector<glm::vec3> wind(blades.texel_count());
  return median_ms(kSteps, [&](int step) {
    for (std::size_t n = 0; n < wind.size(); ++n) wind[n] = breeze(n, step);
    return elapsed_ms([&] { blades.step(wind, kStepS); });
  });
}

}  // namespace

std::vector<Measurement> bench_blade_motion(const BenchOptions&) {
  return {{"inertial.step_ms_100k", inertial_step_ms()}, {"virtual.step_ms_64x64", virtual_step_ms()}};
}

}  // namespace prairie
