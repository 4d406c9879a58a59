#include "animation/treading.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "animation/tread_checks.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Slower than this a body stands.
constexpr double kStandingMPerS = 1e-3;

// Grass whose map says nothing less recovers in this time at the soonest.
constexpr float kLeastRecoveryS = 0.1f;

/// A step as its nodes need it.
struct Path {
  glm::dvec2 from_m;
  glm::dvec2 low_m, high_m;  // box of what it reaches
  glm::dvec2 to_m;
  glm::vec2 forward;  // unit length
  float length_m;
  float radius_m;
  float reach_m;
  float weight;  // times radius²
  bool stands;
};

Path path_of(const TreadStep& step, double reach_radii, double dt_s) {
  Path path{};
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

/// A page that a path may reach.
struct Visit {
  PageIndex page;
  std::uint32_t path;  // in the order of ids

  auto operator<=>(const Visit&) const = default;
};

void add_visits(const Path& path, std::uint32_t index, double spacing_m, std::vector<Visit>& visits) {
  const PageIndex first = page_of(square_of(path.low_m, spacing_m).south_west);
  const PageIndex last = page_of(square_of(path.high_m, spacing_m).south_west);
  const double side_m = kPageNodes * spacing_m;
  for (int j = first.j; j <= last.j; ++j) {
    for (int i = first.i; i <= last.i; ++i) {
      // A long step reaches few of the pages in its box.
      const glm::dvec2 centre_m = (glm::dvec2(i, j) + 0.5) * side_m - path.from_m;
      const glm::dvec2 forward(path.forward);
      const double along_m = std::clamp(glm::dot(centre_m, forward), 0.0, static_cast<double>(path.length_m));
      const double apart_m = glm::length(centre_m - along_m * forward);
      if (apart_m <= static_cast<double>(path.reach_m) + 0.71 * side_m) visits.push_back({{j, i}, index});
    }
  }
}

/// What a page's bodies do to its nodes.
using Pushes = std::array<TreadPush, kPageNodes * kPageNodes>;

/// Adds a path's part to the nodes of the page.
void add_pushes(const Path& path, PageIndex page, double spacing_m, Pushes& pushes) {
  Kernels kernels;
  const NodeIndex corner = page.south_west();
  const auto first = [&](double low_m, int from) {
    return std::max(static_cast<int>(std::ceil(low_m / spacing_m)) - from, 0);
  };
  const auto last = [&](double high_m, int from) {
    return std::min(static_cast<int>(std::floor(high_m / spacing_m)) - from, kPageNodes - 1);
  };
  const int east_end = last(path.high_m.x, corner.i), north_end = last(path.high_m.y, corner.j);
  for (int north = first(path.low_m.y, corner.j); north <= north_end; ++north) {
    for (int east = first(path.low_m.x, corner.i); east <= east_end; ++east) {
      const glm::dvec2 node_m = glm::dvec2(corner.i + east, corner.j + north) * spacing_m;
      const glm::vec2 offset_m(node_m - path.from_m);
      TreadPush& push = pushes[static_cast<std::size_t>(north * kPageNodes + east)];
      const float along_m = path.forward.x * offset_m.x + path.forward.y * offset_m.y;
      const float across_m = path.forward.x * offset_m.y - path.forward.y * offset_m.x;
      const float beyond_m = along_m - std::clamp(along_m, 0.0f, path.length_m);
      const float distance2 = beyond_m * beyond_m + across_m * across_m;
      push.held |= distance2 <= path.radius_m * path.radius_m;
      const float field =
          path.weight * kernels.tread_field(along_m, across_m, path.length_m, path.radius_m, path.reach_m);
      push.field += field;
      push.directed += kernels.tread_direction(path.forward, across_m) * field;
      if (!path.stands) continue;
      const glm::vec2 away_m(node_m - path.to_m);
      const float distance_m = std::sqrt(away_m.x * away_m.x + away_m.y * away_m.y);
      const float standing = path.weight * kernels.standing_field(distance_m, path.radius_m, path.reach_m);
      if (standing > push.standing) {
        push.standing = standing;
        push.outward = distance_m > 0.0f ? away_m / distance_m : glm::vec2(0.0f);
      }
    }
  }
}

/// Calls `visit(slot, index)` for every node of the page in the rectangle: its place in the page and in the
/// rectangle.
template <class Visitor>
void for_nodes(const NodeRect& rect, PageIndex page, Visitor visit) {
  const NodeIndex corner = page.south_west();
  const int first_i = std::max(corner.i, rect.column), first_j = std::max(corner.j, rect.row);
  const int end_i = std::min(corner.i + kPageNodes, rect.column + rect.columns);
  const int end_j = std::min(corner.j + kPageNodes, rect.row + rect.rows);
  for (int j = first_j; j < end_j; ++j) {
    for (int i = first_i; i < end_i; ++i) {
      visit(static_cast<std::size_t>((j - corner.j) * kPageNodes + (i - corner.i)),
            static_cast<std::size_t>(j - rect.row) * static_cast<std::size_t>(rect.columns) +
                static_cast<std::size_t>(i - rect.column));
    }
  }
}

/// Calls `visit(page, nodes)` for the pages that the rectangle meets.
template <class Node, class Visitor>
void for_pages(const NodeRect& rect, const NodeField<Node>& field, Visitor visit) {
  if (rect.columns <= 0 || rect.rows <= 0) return;
  const PageIndex first = page_of({rect.column, rect.row});
  const PageIndex last = page_of({rect.column + rect.columns - 1, rect.row + rect.rows - 1});
  for (int j = first.j; j <= last.j; ++j) {
    auto page = field.pages().lower_bound({.j = j, .i = first.i});
    for (; page != field.pages().end() && page->first.j == j && page->first.i <= last.i; ++page) {
      visit(page->first, page->second);
    }
  }
}

}  // namespace

Treading::Treading(const TreadSettings& settings, NodeGrid recovery_s)
    : settings_(settings),
      recovery_s_(std::move(recovery_s)),
      state_{0.0, NodeField<TreadNode>(checked(settings).spacing_m), NodeField<float>(settings.spacing_m)} {}

void Treading::restore(TreadState state) {
  check_state(settings_, state);
  state_ = std::move(state);
}

void Treading::step(std::span<const TreadStep> steps, double to_s) {
  const double from_s = state_.time_s;
  check_time(from_s, to_s);
  std::vector<std::uint32_t> order(steps.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<std::uint32_t>(n);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return steps[a].id < steps[b].id; });
  check_steps(steps, order);

  std::vector<Path> paths;
  paths.reserve(steps.size());
  std::vector<Visit> visits;
  for (const std::uint32_t n : order) {
    if (steps[n].weight == 0.0) continue;
    paths.push_back(path_of(steps[n], settings_.reach_radii, to_s - from_s));
    add_visits(paths.back(), static_cast<std::uint32_t>(paths.size() - 1), settings_.spacing_m, visits);
  }
  std::sort(visits.begin(), visits.end());

  // Pages are made here and written below, each by one thread.
  struct Work {
    std::size_t first_visit, visits_end;
    NodeField<TreadNode>::Page* nodes;
    NodeField<float>::Page* wear;
  };
  std::vector<Work> work;
  for (std::size_t n = 0; n < visits.size();) {
    const PageIndex page = visits[n].page;
    std::size_t end = n;
    while (end < visits.size() && visits[end].page == page) ++end;
    work.push_back({n, end, &state_.nodes.touch_page(page), &state_.wear.touch_page(page)});
    n = end;
  }

  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, work.size(), 8),
                            [&](const auto& range) {
                              Pushes pushes;
                              for (std::size_t n = range.begin(); n != range.end(); ++n) {
                                pushes.fill({});
                                const PageIndex page = visits[work[n].first_visit].page;
                                for (std::size_t v = work[n].first_visit; v < work[n].visits_end; ++v) {
                                  add_pushes(paths[visits[v].path], page, settings_.spacing_m, pushes);
                                }
                                for (std::size_t slot = 0; slot < pushes.size(); ++slot) {
                                  const TreadPush& push = pushes[slot];
                                  if (!push.held && push.field == 0.0f && push.standing == 0.0f) continue;
                                  TreadNode& node = (*work[n].nodes)[slot];
                                  if (node.blades_recovery_s == 0.0f)
                                    node.blades_recovery_s = blades_recovery_s(page, slot);
                                  press(settings_, push, from_s, to_s, node, (*work[n].wear)[slot]);
                                }
                              }
                            });
  state_.time_s = to_s;

  // Looking for pages at rest once a second is enough.
  if (std::floor(from_s) != std::floor(to_s)) {
    state_.nodes.free_pages([to_s](const TreadNode& node) { return rest_time_s(node) <= to_s; });
    state_.wear.free_pages([](float wear) { return wear == 0.0f; });
  }
}

float Treading::blades_recovery_s(PageIndex page, std::size_t slot) const {
  const NodeIndex corner = page.south_west();
  const int column = static_cast<int>(slot) % kPageNodes, row = static_cast<int>(slot) / kPageNodes;
  const float mapped_s =
      recovery_s_.sample(glm::dvec2(corner.i + column, corner.j + row) * settings_.spacing_m);
  if (!(mapped_s > 0.0f)) return static_cast<float>(settings_.recovery_s);
  return std::clamp(mapped_s, kLeastRecoveryS, kMostRecoveryS);
}

Tread Treading::at(NodeIndex node) const {
  return tread_of(settings_, state_.nodes.at(node), state_.wear.at(node), state_.time_s);
}

Tread Treading::sample(glm::dvec2 position_m) const {
  return state_.nodes.sample(position_m, [this](NodeIndex node) { return at(node); });
}

void Treading::read(const NodeRect& rect, std::span<glm::vec4> out) const {
  assert(out.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  std::fill(out.begin(), out.end(), glm::vec4(0.0f));
  for_pages(rect, state_.wear, [&](PageIndex page, const NodeField<float>::Page& wear) {
    const NodeField<TreadNode>::Page* nodes = state_.nodes.find_page(page);
    for_nodes(rect, page, [&](std::size_t slot, std::size_t index) {
      const TreadNode node = nodes == nullptr ? TreadNode{} : (*nodes)[slot];
      if (node.field == 0.0f && wear[slot] == 0.0f) return;
      const Tread tread = tread_of(settings_, node, wear[slot], state_.time_s);
      out[index] = {tread.lean_rad.x, tread.lean_rad.y, tread.tilt_rad, tread.wear};
    });
  });
}

void Treading::read_wear(const NodeRect& rect, std::span<float> out) const {
  assert(out.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  std::fill(out.begin(), out.end(), 0.0f);
  for_pages(rect, state_.wear, [&](PageIndex page, const NodeField<float>::Page& wear) {
    for_nodes(rect, page, [&](std::size_t slot, std::size_t index) { out[index] = wear[slot]; });
  });
}

void Treading::write_wear(const NodeRect& rect, std::span<const float> wear) {
  assert(wear.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  check_wear(wear);
  std::size_t index = 0;
  for (int row = 0; row < rect.rows; ++row) {
    for (int column = 0; column < rect.columns; ++column, ++index) {
      const NodeIndex node{rect.column + column, rect.row + row};
      // Unworn ground needs no page.
      if (wear[index] > 0.0f || state_.wear.at(node) > 0.0f) state_.wear.touch(node) = wear[index];
    }
  }
}

}  // namespace prairie
