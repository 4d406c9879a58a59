#include "animation/tread_pushes.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/vector_stage.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Slower than this a body stands.
constexpr double kStandingMPerS = 1e-3;

/// Adds a path's part to `count` nodes from `slot` on, eastward from `offset_m` relative to the path's start.
inline void add_row(const TreadPath& path, glm::vec2 offset_m, float spacing_m, std::size_t slot, int count,
                    PagePushes& pushes) {
  Kernels kernels;
  const float radius2 = path.radius_m * path.radius_m;
  for (int n = 0; n < count; ++n) {
    const std::size_t at = slot + static_cast<std::size_t>(n);
    const float east_m = offset_m.x + spacing_m * static_cast<float>(n);
    const float along_m = path.forward.x * east_m + path.forward.y * offset_m.y;
    const float across_m = path.forward.x * offset_m.y - path.forward.y * east_m;
    const float beyond_m = along_m - std::min(std::max(along_m, 0.0f), path.length_m);
    const float distance2 = beyond_m * beyond_m + across_m * across_m;
    const float field =
        path.weight * kernels.tread_field(along_m, across_m, path.length_m, path.radius_m, path.reach_m);
    const glm::vec2 direction = kernels.tread_direction(path.forward, across_m);
    pushes.held[at] = distance2 <= radius2 ? 1.0f : pushes.held[at];
    pushes.field[at] += field;
    pushes.directed_east[at] += direction.x * field;
    pushes.directed_north[at] += direction.y * field;
  }
}

/// The same for what a body does that stands at `offset_m` from the first node.
inline void add_standing_row(const TreadPath& path, glm::vec2 offset_m, float spacing_m, std::size_t slot,
                             int count, PagePushes& pushes) {
  Kernels kernels;
  for (int n = 0; n < count; ++n) {
    const std::size_t at = slot + static_cast<std::size_t>(n);
    const float east_m = offset_m.x + spacing_m * static_cast<float>(n);
    const float distance_m = std::sqrt(east_m * east_m + offset_m.y * offset_m.y);
    const float standing = path.weight * kernels.standing_field(distance_m, path.radius_m, path.reach_m);
    if (standing <= pushes.standing[at]) continue;
    pushes.standing[at] = standing;
    pushes.outward_east[at] = distance_m > 0.0f ? east_m / distance_m : 0.0f;
    pushes.outward_north[at] = distance_m > 0.0f ? offset_m.y / distance_m : 0.0f;
  }
}

}  // namespace

TreadPath path_of(const TreadStep& step, double reach_radii, double dt_s) {
  TreadPath path{};
  path.from_m = step.from_m;
  path.to_m = step.to_m;
  const glm::dvec2 way_m = step.to_m - step.from_m;
  const double length_m = glm::length(way_m);
  const double reach_m = reach_radii * step.radius_m;
  path.low_m = glm::min(step.from_m, step.to_m) - reach_m;
  path.high_m = glm::max(step.from_m, step.to_m) + reach_m;
  path.forward = length_m > 0.0 ? glm::vec2(way_m / length_m) : glm::vec2(1.0f, 0.0f);
  path.length_m = static_cast<float>(length_m);
  path.radius_m = static_cast<float>(step.radius_m);
  path.reach_m = static_cast<float>(reach_m);
  path.weight = static_cast<float>(step.weight * step.radius_m * step.radius_m);
  path.stands = length_m <= kStandingMPerS * dt_s;
  return path;
}

PageBox reached(const TreadPath& path, PageIndex page, double spacing_m) {
  const NodeIndex corner = page.south_west();
  const auto first = [&](double low_m, int from) {
    return std::max(static_cast<int>(std::ceil(low_m / spacing_m)) - from, 0);
  };
  const auto last = [&](double high_m, int from) {
    return std::min(static_cast<int>(std::floor(high_m / spacing_m)) - from, kPageNodes - 1);
  };
  return {first(path.low_m.x, corner.i), first(path.low_m.y, corner.j), last(path.high_m.x, corner.i),
          last(path.high_m.y, corner.j)};
}

PRAIRIE_VECTOR_STAGE void add_pushes(const TreadPath& path, PageIndex page, const PageBox& box,
                                     double spacing_m, PagePushes& pushes) {
  const NodeIndex corner = page.south_west();
  const int count = box.last_i - box.first_i + 1;
  for (int j = box.first_j; j <= box.last_j; ++j) {
    const glm::dvec2 first_m = glm::dvec2(corner.i + box.first_i, corner.j + j) * spacing_m;
    const std::size_t slot = static_cast<std::size_t>(j * kPageNodes + box.first_i);
    const float step_m = static_cast<float>(spacing_m);
    add_row(path, glm::vec2(first_m - path.from_m), step_m, slot, count, pushes);
    if (path.stands) add_standing_row(path, glm::vec2(first_m - path.to_m), step_m, slot, count, pushes);
  }
}

}  // namespace prairie
