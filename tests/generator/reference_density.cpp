#include "tests/generator/reference_density.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace prairie {
namespace {

std::vector<double> cuts(double min_m, double max_m, double origin_m, double spacing_m) {
  std::vector<double> cuts{min_m};
  const double first = std::ceil((min_m - origin_m) / spacing_m);
  for (double node = first; origin_m + node * spacing_m < max_m; node += 1.0) {
    cuts.push_back(origin_m + node * spacing_m);
  }
  cuts.push_back(max_m);
  return cuts;
}

}  // namespace

double density_integral(const NodeGrid& map, glm::dvec2 min_m, glm::dvec2 max_m) {
  if (map.is_uniform()) {
    return static_cast<double>(map.sample(min_m)) * (max_m.x - min_m.x) * (max_m.y - min_m.y);
  }
  const GridFrame& frame = map.frame();
  const std::vector<double> x = cuts(min_m.x, max_m.x, frame.origin_m.x, frame.spacing_m);
  const std::vector<double> y = cuts(min_m.y, max_m.y, frame.origin_m.y, frame.spacing_m);
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const double area_m2 = (x[i + 1] - x[i]) * (y[j + 1] - y[j]);
      if (area_m2 <= 0.0) continue;
      sum += area_m2 * static_cast<double>(map.sample({0.5 * (x[i] + x[i + 1]), 0.5 * (y[j] + y[j + 1])}));
    }
  }
  return sum;
}

}  // namespace prairie
