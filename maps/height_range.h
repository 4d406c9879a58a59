// A closed interval of heights, metres.
#pragma once

#include <algorithm>

namespace prairie {

struct HeightRange {
  float min_m = 0.0f;
  float max_m = 0.0f;
};

/// The smallest range that contains both.
inline HeightRange united(HeightRange a, HeightRange b) {
  return {std::min(a.min_m, b.min_m), std::max(a.max_m, b.max_m)};
}

}  // namespace prairie
