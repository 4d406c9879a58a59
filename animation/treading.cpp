#include "animation/treading.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "animation/tread_checks.h"
#include "animation/tread_pushes.h"

namespace prairie {

/// A page that a path may reach.
struct Treading::Visit {
  PageIndex page;
  std::uint32_t path;  // in the order of ids

  auto operator<=>(const Visit&) const = default;
};

/// What a step's bodies do.
struct Treading::Passage {
  std::vector<TreadPath> paths;
  std::vector<Visit> visits;  // by page
  double from_s, to_s;
};

/// A page and the paths that may reach it.
struct Treading::VisitedPage {
  std::span<const Visit> visits;
  NodeField<TreadNode>::Page* nodes;
  NodeField<float>::Page* wear;

  PageIndex index() const { return visits.front().page; }
};

namespace {

// Grass whose map says nothing less recovers in this time at the soonest.
constexpr float kLeastRecoveryS = 0.1f;
constexpr std::size_t kPagesAtOnce = 8;  // that a thread takes

/// Asks for memory that is needed soon.
void fetch(const TreadNode* nodes, std::size_t count) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64 / sizeof(TreadNode);
  for (std::size_t n = 0; n < count; n += kLine) __builtin_prefetch(nodes + n, 1);
  __builtin_prefetch(nodes + count - 1, 1);
#else
  static_cast<void>(nodes), static_cast<void>(count);
#endif
}

/// Calls `visit(slot, index, count)` for every row of the page's nodes in the rectangle: where its first lies
/// in the page and in the rectangle, and how many there are.
template <class Visitor>
void for_rows(const NodeRect& rect, PageIndex page, Visitor visit) {
  const NodeIndex corner = page.south_west();
  const int first_i = std::max(corner.i, rect.column), first_j = std::max(corner.j, rect.row);
  const int end_i = std::min(corner.i + kPageNodes, rect.column + rect.columns);
  const int end_j = std::min(corner.j + kPageNodes, rect.row + rect.rows);
  for (int j = first_j; j < end_j; ++j) {
    visit(static_cast<std::size_t>((j - corner.j) * kPageNodes + (first_i - corner.i)),
          static_cast<std::size_t>(j - rect.row) * static_cast<std::size_t>(rect.columns) +
              static_cast<std::size_t>(first_i - rect.column),
          static_cast<std::size_t>(end_i - first_i));
  }
}

/// Calls `visit(page, nodes)` for the pages that the rectangle meets.
template <class Node, class Visitor>
void for_pages(const NodeRect& rect, const NodeField<Node>& field, Visitor visit) {
  if (rect.columns <= 0 || rect.rows <= 0) return;
  field.for_pages(page_of({rect.column, rect.row}),
                  page_of({rect.column + rect.columns - 1, rect.row + rect.rows - 1}), visit);
}

/// Reads nodes, and looks for a page only where it is another than for the last one.
template <class Node>
class PageFinder {
 public:
  explicit PageFinder(const NodeField<Node>& field) : field_(field) {}

  Node at(NodeIndex node) {
    const PageIndex page = page_of(node);
    if (page != page_ || !has_looked_) {
      nodes_ = field_.find_page(page);
      page_ = page;
      has_looked_ = true;
    }
    return nodes_ == nullptr ? Node{} : (*nodes_)[slot_of(node)];
  }

 private:
  const NodeField<Node>& field_;
  PageIndex page_;
  const typename NodeField<Node>::Page* nodes_ = nullptr;
  bool has_looked_ = false;
};

}  // namespace

Treading::Treading(const TreadSettings& settings, NodeGrid recovery_s)
    : settings_(settings),
      recovery_s_(std::move(recovery_s)),
      state_{0.0, NodeField<TreadNode>(checked(settings).spacing_m), NodeField<float>(settings.spacing_m)} {}

void Treading::restore(TreadState state) {
  check_state(settings_, state);
  state_ = std::move(state);
  ++revision_;
}

void Treading::add_visits(const TreadPath& path, std::uint32_t index, double spacing_m,
                          std::vector<Visit>& visits) {
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

void Treading::step(std::span<const TreadStep> steps, double to_s) {
  const double from_s = state_.time_s;
  check_time(from_s, to_s);
  std::vector<std::uint32_t> order(steps.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<std::uint32_t>(n);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return steps[a].id < steps[b].id; });
  check_steps(steps, order);

  Passage passage{{}, {}, from_s, to_s};
  for (const std::uint32_t n : order) {
    if (steps[n].weight == 0.0) continue;
    passage.paths.push_back(path_of(steps[n], settings_.reach_radii, to_s - from_s));
    add_visits(passage.paths.back(), static_cast<std::uint32_t>(passage.paths.size() - 1),
               settings_.spacing_m, passage.visits);
  }
  std::sort(passage.visits.begin(), passage.visits.end());
  const std::vector<VisitedPage> pages = visited_pages(passage);
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, pages.size(), kPagesAtOnce),
                            [&](const auto& range) {
                              PagePushes pushes;
                              for (std::size_t n = range.begin(); n != range.end(); ++n)
                                press_page(passage, pages[n], pushes);
                            });
  state_.time_s = to_s;
  ++revision_;

  // Looking for pages at rest once a second is enough.
  if (std::floor(from_s) != std::floor(to_s)) {
    state_.nodes.free_pages([to_s](const TreadNode& node) { return rest_time_s(node) <= to_s; });
    state_.wear.free_pages([](float wear) { return wear == 0.0f; });
  }
}

/// The pages that paths visit, each once, so that every page is written by one thread; those that there are
/// not yet are made.
std::vector<Treading::VisitedPage> Treading::visited_pages(const Passage& passage) {
  std::vector<VisitedPage> pages;
  const std::vector<Visit>& visits = passage.visits;
  for (std::size_t n = 0; n < visits.size();) {
    std::size_t end = n;
    while (end < visits.size() && visits[end].page == visits[n].page) ++end;
    pages.push_back({std::span(visits).subspan(n, end - n), nullptr, nullptr});
    n = end;
  }
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, pages.size(), kPagesAtOnce),
                            [&](const auto& range) {
                              for (std::size_t n = range.begin(); n != range.end(); ++n) {
                                pages[n].nodes = state_.nodes.find_page(pages[n].index());
                                pages[n].wear = state_.wear.find_page(pages[n].index());
                              }
                            });
  for (VisitedPage& page : pages) {
    if (page.nodes == nullptr) page.nodes = &state_.nodes.touch_page(page.index());
    if (page.wear == nullptr) page.wear = &state_.wear.touch_page(page.index());
  }
  return pages;
}

/// Presses the nodes of a page that the passage reaches; `pushes` is for its use alone.
void Treading::press_page(const Passage& passage, const VisitedPage& page, PagePushes& pushes) const {
  PageBox all;
  bool one_stands = false;
  for (const Visit& visit : page.visits) {
    const TreadPath& path = passage.paths[visit.path];
    const PageBox box = reached(path, page.index(), settings_.spacing_m);
    if (box.first_i > box.last_i || box.first_j > box.last_j) continue;
    one_stands |= path.stands;
    all = {std::min(all.first_i, box.first_i), std::min(all.first_j, box.first_j),
           std::max(all.last_i, box.last_i), std::max(all.last_j, box.last_j)};
  }
  if (all.first_i > all.last_i) return;
  const auto slot_at = [&](int j) { return static_cast<std::size_t>(j * kPageNodes + all.first_i); };
  const std::size_t columns = static_cast<std::size_t>(all.last_i - all.first_i + 1);
  // Nodes of a wide meadow are not in the cache: they are fetched while the pushes are summed.
  for (int j = all.first_j; j <= all.last_j; ++j) fetch(&(*page.nodes)[slot_at(j)], columns);
  pushes.clear(all.first_j, all.last_j, one_stands);
  for (const Visit& visit : page.visits) {
    const TreadPath& path = passage.paths[visit.path];
    add_pushes(path, page.index(), reached(path, page.index(), settings_.spacing_m), settings_.spacing_m,
               pushes);
  }
  for (int j = all.first_j; j <= all.last_j; ++j) {
    for (std::size_t slot = slot_at(j); slot < slot_at(j) + columns; ++slot) {
      if (!pushes.touches(slot)) continue;
      TreadNode& node = (*page.nodes)[slot];
      if (node.blades_recovery_s == 0.0f) node.blades_recovery_s = blades_recovery_s(page.index(), slot);
      press(settings_, pushes.at(slot), passage.from_s, passage.to_s, node, (*page.wear)[slot]);
    }
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
  Tread tread;
  sample({&position_m, 1}, {&tread, 1});
  return tread;
}

void Treading::sample(std::span<const glm::dvec2> positions_m, std::span<Tread> treads) const {
  assert(positions_m.size() == treads.size());
  constexpr std::size_t kTogether = 16;
  std::array<NodeSquare, kTogether> squares;
  std::array<TreadNode, 4 * kTogether> nodes;
  std::array<float, 4 * kTogether> wear;
  std::array<glm::vec4, 4 * kTogether> at;
  PageFinder<TreadNode> node_pages(state_.nodes);
  PageFinder<float> wear_pages(state_.wear);
  for (std::size_t first = 0; first < positions_m.size(); first += kTogether) {
    const std::size_t count = std::min(kTogether, positions_m.size() - first);
    for (std::size_t n = 0; n < count; ++n) {
      squares[n] = square_of(positions_m[first + n], settings_.spacing_m);
      const NodeIndex corner = squares[n].south_west;
      for (int k = 0; k < 4; ++k) {
        const NodeIndex node{corner.i + k % 2, corner.j + k / 2};
        nodes[4 * n + static_cast<std::size_t>(k)] = node_pages.at(node);
        wear[4 * n + static_cast<std::size_t>(k)] = wear_pages.at(node);
      }
    }
    treads_of(settings_, std::span(nodes).first(4 * count), std::span(wear).first(4 * count), state_.time_s,
              std::span(at).first(4 * count));
    for (std::size_t n = 0; n < count; ++n) {
      const float east = squares[n].east, north = squares[n].north;
      const glm::vec4 south = at[4 * n] * (1.0f - east) + at[4 * n + 1] * east;
      const glm::vec4 norths = at[4 * n + 2] * (1.0f - east) + at[4 * n + 3] * east;
      const glm::vec4 tread = south * (1.0f - north) + norths * north;
      treads[first + n] = {glm::vec2(tread), tread.z, tread.w};
    }
  }
}

void Treading::read(const NodeRect& rect, std::span<glm::vec4> out) const {
  assert(out.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  std::fill(out.begin(), out.end(), glm::vec4(0.0f));
  static const NodeField<TreadNode>::Page kAtRest{};
  for_pages(rect, state_.wear, [&](PageIndex page, const NodeField<float>::Page& wear) {
    const NodeField<TreadNode>::Page* found = state_.nodes.find_page(page);
    const NodeField<TreadNode>::Page& nodes = found == nullptr ? kAtRest : *found;
    for_rows(rect, page, [&](std::size_t slot, std::size_t index, std::size_t count) {
      treads_of(settings_, std::span(nodes).subspan(slot, count), std::span(wear).subspan(slot, count),
                state_.time_s, out.subspan(index, count));
    });
  });
}

void Treading::read_wear(const NodeRect& rect, std::span<float> out) const {
  assert(out.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  std::fill(out.begin(), out.end(), 0.0f);
  for_pages(rect, state_.wear, [&](PageIndex page, const NodeField<float>::Page& wear) {
    for_rows(rect, page, [&](std::size_t slot, std::size_t index, std::size_t count) {
      std::copy_n(wear.begin() + static_cast<std::ptrdiff_t>(slot), count,
                  out.begin() + static_cast<std::ptrdiff_t>(index));
    });
  });
}

void Treading::write_wear(const NodeRect& rect, std::span<const float> wear) {
  assert(wear.size() == static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  check_wear(wear);
  ++revision_;
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
