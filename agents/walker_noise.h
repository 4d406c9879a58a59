// Random numbers of a crowd: functions of seed, walker, purpose and a count or a time, so that nobody's
// depend on how many others there are.
#pragma once

#include <array>
#include <cstdint>

namespace prairie {

enum class NoiseOf : std::uint32_t { kStart = 0x77616c6bu, kSpeed, kHeading, kWander, kTraits };

/// Three numbers in [0, 1), the n-th such triple.
std::array<double, 3> units(std::uint32_t seed, std::uint32_t walker, NoiseOf purpose, std::uint32_t n);

/// Gaussian, of mean 0 and deviation 1 at all times, smooth in time.
double noise_at(std::uint32_t seed, std::uint32_t walker, NoiseOf purpose, double time_s);

}  // namespace prairie
