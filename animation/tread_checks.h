// What treading accepts from outside; every fault is a BadInput that names the field and what was expected.
#pragma once

#include <cstdint>
#include <span>

#include "animation/treading.h"

namespace prairie {

/// A year.
inline constexpr float kMostRecoveryS = 3.2e7f;

/// Things are no farther from the origin along an axis: node indices stay within an int at any spacing, and a
/// float still tells a millimetre inside a page.
inline constexpr double kFarthestM = 1e7;

/// The settings themselves.
const TreadSettings& checked(const TreadSettings& settings);

void check_time(double from_s, double to_s);

/// `order`: indices of the steps, sorted by id.
void check_steps(std::span<const TreadStep> steps, std::span<const std::uint32_t> order);

void check_state(const TreadSettings& settings, const TreadState& state);

void check_wear(std::span<const float> wear);

}  // namespace prairie
