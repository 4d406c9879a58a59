#include "agents/walker_noise.h"

#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr double kNoiseKnotS = 0.8;  // between independent values

/// Gaussian but for its tails, which end at ±6: the sum of twelve uniform numbers.
double gaussian(std::uint32_t seed, std::uint32_t walker, NoiseOf purpose, std::uint32_t n) {
  Kernels kernels;
  double sum = 0.0;
  for (std::uint32_t part = 0; part < 2; ++part) {
    const glm::uvec3 words = kernels.hash_uvec3(
        glm::uvec3(seed ^ kernels.hash_u32(static_cast<std::uint32_t>(purpose)), walker, 2 * n + part));
    for (const std::uint32_t word : {words.x, words.y, words.z})
      sum += static_cast<double>(kernels.unit_from_low16(word)) +
             static_cast<double>(kernels.unit_from_high16(word));
  }
  return sum - 6.0 + 12.0 * 0.5 / 65536.0;
}

}  // namespace

std::array<double, 3> units(std::uint32_t seed, std::uint32_t walker, NoiseOf purpose, std::uint32_t n) {
  Kernels kernels;
  const glm::uvec3 words =
      kernels.hash_uvec3(glm::uvec3(seed ^ kernels.hash_u32(static_cast<std::uint32_t>(purpose)), walker, n));
  return {static_cast<double>(kernels.unit_from_u32(words.x)),
          static_cast<double>(kernels.unit_from_u32(words.y)),
          static_cast<double>(kernels.unit_from_u32(words.z))};
}

double noise_at(std::uint32_t seed, std::uint32_t walker, NoiseOf purpose, double time_s) {
  const double knots = time_s / kNoiseKnotS, knot = std::floor(knots), t = knots - knot;
  const auto n = static_cast<std::uint32_t>(static_cast<std::int64_t>(knot));
  const double a = 1.0 - t, b = t;
  return (a * gaussian(seed, walker, purpose, n) + b * gaussian(seed, walker, purpose, n + 1)) /
         std::sqrt(a * a + b * b);
}

}  // namespace prairie
