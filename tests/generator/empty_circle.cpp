#include "tests/generator/empty_circle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace prairie {
namespace {

constexpr int kGrid = 64;

struct Site {
  glm::dvec2 place;
  double squared;  // distance to the nearest point
};

template <bool kTorus>
double nearest_squared(std::span<const glm::dvec2> points, glm::dvec2 place) {
  double nearest = 1e9;
  for (const glm::dvec2& point : points) {
    double x = std::abs(point.x - place.x);
    double y = std::abs(point.y - place.y);
    if (kTorus) {
      x = std::min(x, 1.0 - x);
      y = std::min(y, 1.0 - y);
    }
    nearest = std::min(nearest, x * x + y * y);
  }
  return nearest;
}

/// Climbs from a grid place towards the middle of its empty circle by ever smaller steps.
template <bool kTorus>
Site refined(std::span<const glm::dvec2> points, Site site) {
  for (double step = 0.5 / kGrid; step > 0.02 / kGrid; step *= 0.5) {
    const Site from = site;
    for (int n = 0; n < 9; ++n) {
      glm::dvec2 place = from.place + step * glm::dvec2(n % 3 - 1, n / 3 - 1);
      place = kTorus ? place - glm::dvec2(std::floor(place.x), std::floor(place.y))
                     : glm::dvec2(std::clamp(place.x, 0.0, 1.0), std::clamp(place.y, 0.0, 1.0));
      const double squared = nearest_squared<kTorus>(points, place);
      if (squared > site.squared) site = {place, squared};
    }
  }
  return site;
}

template <bool kTorus>
double largest_circle(std::span<const glm::dvec2> points) {
  std::vector<Site> sites;
  for (int y = 0; y < kGrid; ++y) {
    for (int x = 0; x < kGrid; ++x) {
      const glm::dvec2 place((x + 0.5) / kGrid, (y + 0.5) / kGrid);
      sites.push_back({place, nearest_squared<kTorus>(points, place)});
    }
  }
  constexpr std::size_t kRefined = 8;
  std::partial_sort(sites.begin(), sites.begin() + kRefined, sites.end(),
                    [](const Site& a, const Site& b) { return a.squared > b.squared; });
  double largest = 0.0;
  for (std::size_t n = 0; n < kRefined; ++n) {
    largest = std::max(largest, refined<kTorus>(points, sites[n]).squared);
  }
  return std::sqrt(largest);
}

}  // namespace

double largest_empty_circle(std::span<const glm::dvec2> points) {
  return largest_circle<true>(points);
}

double largest_empty_circle_in_square(std::span<const glm::dvec2> points) {
  return largest_circle<false>(points);
}

}  // namespace prairie
