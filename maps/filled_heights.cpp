#include "maps/filled_heights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <list>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "maps/ground_survey.h"
#include "maps/node_mask.h"

namespace prairie {
namespace {

constexpr std::size_t kMaxPages = 64;
constexpr int kPageNodes = 2048;  // a side, of heights in memory

std::size_t cells(int columns, int rows) {
  return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

bool has_gap(std::span<const float> values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return std::isnan(v); });
}

/// A window of a map that is filled by itself: begins on a corner of the overview's cells and ends on one or
/// at the grid's border.
NodeRect window_around(const GridFrame& frame, int level, const NodeRect& page) {
  const int cell = 1 << level;
  const int margin = kFillReachCells * cell;
  const int column = std::max(0, (page.column - margin) / cell * cell);
  const int row = std::max(0, (page.row - margin) / cell * cell);
  const auto end = [cell](int last, int count) { return std::min((last / cell + 1) * cell, count); };
  return {column, row, end(page.column + page.columns - 1 + margin, frame.columns) - column,
          end(page.row + page.rows - 1 + margin, frame.rows) - row};
}

/// The overview's cells over a window.
FillLevel overview_of(const GroundOverview& overview, const NodeRect& window, int columns, int rows) {
  FillLevel part{columns, rows, {}, {}, {}};
  const FillLevel& all = overview.cells;
  const auto copy = [&](const std::vector<float>& from, std::vector<float>* to) {
    for (int j = 0; j < rows; ++j) {
      const float* row = from.data() + cells(all.columns, (window.row >> overview.level) + j) +
                         (window.column >> overview.level);
      to->insert(to->end(), row, row + columns);
    }
  };
  copy(all.heights_m, &part.heights_m);
  copy(all.east_m, &part.east_m);
  copy(all.north_m, &part.north_m);
  return part;
}

std::vector<float> filled_page(const NodeGrid& measured_m, const GroundOverview& overview,
                               const NodeRect& page) {
  const NodeRect window = window_around(measured_m.frame(), overview.level, page);
  std::vector<float> nodes(cells(window.columns, window.rows));
  measured_m.read_block(window, nodes);
  std::vector<FillLevel> levels{finest_level(window.columns, window.rows, false, nodes)};
  while (static_cast<int>(levels.size()) < overview.level) levels.push_back(coarser_level(levels.back()));
  const FillLevel& last = levels.back();
  FillLevel coarser = overview_of(overview, window, (last.columns + 1) / 2, (last.rows + 1) / 2);
  for (std::size_t k = levels.size(); k-- > 0;) {
    fill_from_coarser(coarser, 1 << k, false, &levels[k]);
    coarser = std::move(levels[k]);
  }
  std::vector<float> result;
  result.reserve(cells(page.columns, page.rows));
  for (int j = 0; j < page.rows; ++j) {
    const float* row = coarser.heights_m.data() + cells(window.columns, page.row - window.row + j) +
                       (page.column - window.column);
    result.insert(result.end(), row, row + page.columns);
  }
  return result;
}

/// The nodes of a grid in memory as they were measured, while its gaps are being filled.
class MeasuredNodes : public NodeSource {
 public:
  MeasuredNodes(int columns, std::span<const float> values, const NodeMask& gaps)
      : columns_(columns), values_(values), gaps_(gaps) {}

  void read(const NodeRect& rect, std::span<float> out) const override {
    for (int j = 0; j < rect.rows; ++j) {
      const int row = rect.row + j;
      const float* from = values_.data() + cells(columns_, row) + static_cast<std::size_t>(rect.column);
      float* to = out.data() + cells(rect.columns, j);
      for (int i = 0; i < rect.columns; ++i)
        to[i] = gaps_.is_marked(rect.column + i, row) ? std::numeric_limits<float>::quiet_NaN() : from[i];
    }
  }

 private:
  int columns_;
  std::span<const float> values_;
  const NodeMask& gaps_;
};

/// A page pays for the window around it; the wider the window, the larger the page that is worth it.
std::vector<NodeRect> pages_with_gaps(const GridFrame& frame, int page_nodes, const NodeMask& gaps) {
  std::vector<NodeRect> pages;
  for (int row = 0; row < frame.rows; row += page_nodes) {
    for (int column = 0; column < frame.columns; column += page_nodes) {
      const NodeRect page{column, row, std::min(page_nodes, frame.columns - column),
                          std::min(page_nodes, frame.rows - row)};
      if (gaps.any(page)) pages.push_back(page);
    }
  }
  return pages;
}

class FilledHeights : public NodeSource {
 public:
  FilledHeights(NodeGrid measured, GroundOverview overview)
      : measured_(std::move(measured)),
        overview_(std::move(overview)),
        // A page pays for the window around it; the wider the window, the larger the page that is worth it.
        page_nodes_(std::max(64, 8 << overview_.level)) {}

  void read(const NodeRect& rect, std::span<float> out) const override {
    measured_.read_block(rect, out);
    if (!has_gap(out.first(cells(rect.columns, rect.rows)))) return;
    for (int y = rect.row / page_nodes_; y * page_nodes_ < rect.row + rect.rows; ++y) {
      for (int x = rect.column / page_nodes_; x * page_nodes_ < rect.column + rect.columns; ++x) {
        copy_gaps(x, y, rect, out);
      }
    }
  }

 private:
  using Page = std::shared_ptr<const std::vector<float>>;
  using Key = std::pair<int, int>;

  NodeRect page_rect(int x, int y) const {
    const GridFrame& frame = measured_.frame();
    return {x * page_nodes_, y * page_nodes_, std::min(page_nodes_, frame.columns - x * page_nodes_),
            std::min(page_nodes_, frame.rows - y * page_nodes_)};
  }

  void copy_gaps(int x, int y, const NodeRect& rect, std::span<float> out) const {
    const NodeRect page = page_rect(x, y);
    const int first_column = std::max(page.column, rect.column);
    const int last_column = std::min(page.column + page.columns, rect.column + rect.columns);
    Page filled;
    for (int row = std::max(page.row, rect.row); row < std::min(page.row + page.rows, rect.row + rect.rows);
         ++row) {
      for (int column = first_column; column < last_column; ++column) {
        float& value =
            out[cells(rect.columns, row - rect.row) + static_cast<std::size_t>(column - rect.column)];
        if (!std::isnan(value)) continue;
        if (filled == nullptr) filled = fetch(x, y);
        value =
            (*filled)[cells(page.columns, row - page.row) + static_cast<std::size_t>(column - page.column)];
      }
    }
  }

  Page fetch(int x, int y) const {
    const Key key{y, x};
    {
      const std::lock_guard lock(mutex_);
      const auto found = pages_.find(key);
      if (found != pages_.end()) {
        order_.splice(order_.begin(), order_, found->second.place);
        return found->second.page;
      }
    }
    // Two threads may fill the same page; both get the same bits.
    const Page page =
        std::make_shared<const std::vector<float>>(filled_page(measured_, overview_, page_rect(x, y)));
    const std::lock_guard lock(mutex_);
    if (pages_.find(key) != pages_.end()) return page;
    order_.push_front(key);
    pages_[key] = {page, order_.begin()};
    if (pages_.size() > kMaxPages) {
      pages_.erase(order_.back());
      order_.pop_back();
    }
    return page;
  }

  struct Entry {
    Page page;
    std::list<Key>::iterator place;
  };

  NodeGrid measured_;
  GroundOverview overview_;
  int page_nodes_;
  mutable std::mutex mutex_;
  mutable std::map<Key, Entry> pages_;
  mutable std::list<Key> order_;  // most recently used first
};

}  // namespace

NodeGrid filled_heights(const NodeGrid& measured_m, GroundOverview overview) {
  return NodeGrid(measured_m.frame(), 1, std::make_shared<FilledHeights>(measured_m, std::move(overview)),
                  false);
}

void fill_page_by_page(const GridFrame& frame, const NodeMask& gaps, std::span<float> heights_m) {
  const NodeGrid measured_m(frame, 1, std::make_shared<MeasuredNodes>(frame.columns, heights_m, gaps));
  const GroundOverview overview = survey_ground(measured_m).overview;
  const std::vector<NodeRect> pages = pages_with_gaps(frame, std::max(kPageNodes, 8 << overview.level), gaps);
  for (const NodeRect& page : pages) {
    const std::vector<float> filled = filled_page(measured_m, overview, page);
    for (int j = 0; j < page.rows; ++j) {
      for (int i = 0; i < page.columns; ++i) {
        if (!gaps.is_marked(page.column + i, page.row + j)) continue;
        heights_m[cells(frame.columns, page.row + j) + static_cast<std::size_t>(page.column + i)] =
            filled[cells(page.columns, j) + static_cast<std::size_t>(i)];
      }
    }
  }
}

}  // namespace prairie
