#include "bench/timing.h"

#include <algorithm>
#include <cstddef>

namespace prairie {

double quantile(std::vector<double> values, double share) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, nth);
  return *nth;
}

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

}  // namespace prairie
