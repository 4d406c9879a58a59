// Ranges that keys of several sections share.
#pragma once

#include <limits>

#include "world/scene/toml_reader.h"

namespace prairie {

inline constexpr Bounds kPositionM{-1e6, 1e6};
inline constexpr Bounds kBearingDeg{-360.0, 360.0};
inline constexpr Bounds kShare{0.0, 1.0};
inline constexpr Bounds kAnyNumber{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

}  // namespace prairie
