#include "animation/eye_windows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "animation/torus.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kSwaySide;

std::size_t wrapped(int i) {
  return static_cast<std::size_t>(prairie::wrapped(i, kSide));
}

/// Along an axis: the texel before a place, and the share of the way to the next one.
struct Between {
  std::size_t before, after;
  float share;
};

Between between(double position_m, double size_m) {
  const double at = position_m / size_m - 0.5, below = std::floor(at);
  const int index = static_cast<int>(below);
  return {wrapped(index), wrapped(index + 1), static_cast<float>(at - below)};
}

WindowBlend blend_of(const Between& column, const Between& row) {
  return {{row.before * kSide + column.before, row.before * kSide + column.after,
           row.after * kSide + column.before, row.after * kSide + column.after},
          column.share,
          row.share};
}

/// Along an axis, of a texel of a torus: how far from the centre, and where in the next coarser window.
struct Place {
  double away_m;
  Between coarser;
};

std::array<Place, kSide> places_along(int corner, double size_m, double centre_m) {
  std::array<Place, kSide> places;
  for (int n = 0; n < kSide; ++n) {
    const double middle_m = (corner + n + 0.5) * size_m;
    places[wrapped(corner + n)] = {std::abs(middle_m - centre_m),
                                   between(middle_m, size_m * double{layouts::kSwayCoarsening})};
  }
  return places;
}

}  // namespace

double window_texel_m(std::size_t level) {
  double texel_m = static_cast<double>(layouts::kSwayFinestM);
  for (std::size_t n = 0; n < level; ++n) texel_m *= static_cast<double>(layouts::kSwayCoarsening);
  return texel_m;
}

double window_half_m(std::size_t level) {
  return 0.5 * kSide * window_texel_m(level);
}

std::size_t window_index(int i, int j) {
  return torus_index(i, j, kSide);
}

glm::ivec2 window_corner(std::size_t level, glm::dvec2 eye_m) {
  return corner_around(eye_m, window_texel_m(level), kSide);
}

double fade_start_m(double half) {
  return 0.75 * half;
}

double fade_end_m(double half) {
  return 0.9375 * half;
}

void fade_window(std::size_t level, glm::dvec2 centre_m, std::span<glm::vec4* const> tori,
                 std::span<const glm::vec4* const> coarser) {
  const bool is_last = level + 1 == kWindowLevels;
  assert(is_last || coarser.size() == tori.size());
  std::vector<glm::vec4> means(tori.size(), glm::vec4(0.0f));
  if (is_last) {
    for (std::size_t l = 0; l < tori.size(); ++l) {
      for (std::size_t n = 0; n < kWindowTexels; ++n) means[l] += tori[l][n];
      means[l] /= static_cast<float>(kWindowTexels);
    }
  }
  const double size_m = window_texel_m(level), half_m = window_half_m(level);
  const double start_m = fade_start_m(half_m), end_m = fade_end_m(half_m);
  const glm::ivec2 corner = window_corner(level, centre_m);
  const std::array<Place, kSide> columns = places_along(corner.x, size_m, centre_m.x);
  const std::array<Place, kSide> rows = places_along(corner.y, size_m, centre_m.y);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kSide, 8), [&](const auto& range) {
    for (std::size_t row = range.begin(); row != range.end(); ++row) {
      for (std::size_t column = 0; column < kSide; ++column) {
        const double distance_m = std::max(columns[column].away_m, rows[row].away_m);
        if (distance_m <= start_m) continue;
        const auto share = static_cast<float>(std::min((distance_m - start_m) / (end_m - start_m), 1.0));
        const WindowBlend beyond = blend_of(columns[column].coarser, rows[row].coarser);
        for (std::size_t l = 0; l < tori.size(); ++l) {
          glm::vec4& texel = tori[l][row * kSide + column];
          texel += ((is_last ? means[l] : beyond.of(coarser[l])) - texel) * share;
        }
      }
    }
  });
}

WindowPlace window_place(glm::dvec2 centre_m, glm::dvec2 position_m) {
  const glm::dvec2 away_m = position_m - centre_m;
  const double distance_m = std::max(std::abs(away_m.x), std::abs(away_m.y));
  std::size_t level = 0;
  while (level + 1 < kWindowLevels && distance_m >= fade_end_m(window_half_m(level))) ++level;
  // Beyond the last window a texel farther, so that no blend reaches back into it.
  const double most_m = fade_end_m(window_half_m(kWindowLevels - 1)) + window_texel_m(kWindowLevels - 1);
  return {level, centre_m + glm::clamp(away_m, -most_m, most_m)};
}

WindowBlend window_blend(std::size_t level, glm::dvec2 position_m) {
  const double size_m = window_texel_m(level);
  return blend_of(between(position_m.x, size_m), between(position_m.y, size_m));
}

}  // namespace prairie
