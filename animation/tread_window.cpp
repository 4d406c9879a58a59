#include "animation/tread_window.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/eye_windows.h"
#include "animation/torus.h"
#include "generator/vector_stage.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kTreadSide;
constexpr std::size_t kTexels = std::size_t{kSide} * kSide;

double texel_m(int level) {
  return static_cast<double>(layouts::kSwayFinestM) * layouts::kSwaySide / kSide *
         std::pow(static_cast<double>(layouts::kSwayCoarsening), level);
}

// A texel along an axis: the mean of up to four nodes.
struct Taps {
  std::array<int, 4> nodes;
  std::array<float, 4> weights;
};

/// A page's nodes with some beyond its eastern and northern border, and around it as far as texels sample
/// aside.
class PageNodes {
 public:
  void read(const Treading& treading, PageIndex page, double aside_m) {
    spacing_m_ = treading.settings().spacing_m;
    aside_m_ = aside_m;
    const int margin = static_cast<int>(std::ceil(aside_m / spacing_m_));
    side_ = kPageNodes + 1 + 2 * margin;
    south_west_ = {page.south_west().i - margin, page.south_west().j - margin};
    nodes_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    treading.read({south_west_.i, south_west_.j, side_, side_}, nodes_);
  }

  bool are_at_rest() const {
    return std::ranges::all_of(nodes_, [](glm::vec4 tread) { return tread == glm::vec4(0.0f); });
  }

  int side() const { return side_; }
  const glm::vec4* row(int j) const { return &nodes_[static_cast<std::size_t>(j * side_)]; }
  Taps column_at(double x_m) const { return taps(x_m, south_west_.i); }
  Taps row_at(double y_m) const { return taps(y_m, south_west_.j); }

 private:
  Taps taps(double position_m, int first) const {
    Taps found;
    for (std::size_t n = 0; n < 2; ++n) {
      const double nodes = (position_m + (n == 0 ? -aside_m_ : aside_m_)) / spacing_m_,
                   below = std::floor(nodes);
      const int from = static_cast<int>(below) - first;
      const float share = static_cast<float>(nodes - below);
      assert(from >= 0 && from + 1 < side_);
      found.nodes[2 * n] = from;
      found.nodes[2 * n + 1] = from + 1;
      found.weights[2 * n] = 0.5f * (1.0f - share);
      found.weights[2 * n + 1] = 0.5f * share;
    }
    return found;
  }

  double spacing_m_ = 0.0, aside_m_ = 0.0;
  int side_ = 0;
  NodeIndex south_west_;
  std::vector<glm::vec4> nodes_;
};

/// A row of texels from a page's nodes; `shares`: by which each is multiplied.
PRAIRIE_VECTOR_STAGE void paint_row(const PageNodes& nodes, const Taps& up, std::span<const Taps> across,
                                    std::span<const float> shares, std::span<glm::vec4> row,
                                    std::span<TreadTexel> texels) {
  const glm::vec4* from[4];
  for (std::size_t k = 0; k < 4; ++k) from[k] = nodes.row(up.nodes[k]);
  for (std::size_t n = 0; n < row.size(); ++n)
    row[n] = (from[0][n] * up.weights[0] + from[1][n] * up.weights[1]) +
             (from[2][n] * up.weights[2] + from[3][n] * up.weights[3]);
  const glm::vec4 unit = 127.0f / glm::vec4(glm::vec3(layouts::kTreadMostRad), 1.0f);
  for (std::size_t n = 0; n < texels.size(); ++n) {
    const Taps& taps = across[n];
    glm::vec4 tread(0.0f);
    for (std::size_t k = 0; k < 4; ++k)
      tread += row[static_cast<std::size_t>(taps.nodes[k])] * taps.weights[k];
    tread *= unit * shares[n];
    for (int c = 0; c < 4; ++c) {
      const float steps = std::min(std::max(tread[c], -127.0f), 127.0f);
      texels[n][static_cast<std::size_t>(c)] =
          static_cast<std::int8_t>(static_cast<int>(steps + (steps < 0.0f ? -0.5f : 0.5f)));
    }
  }
}

// How far from its middle a texel samples: not at all where nodes are no closer than texels.
double aside_m_of(int level, double spacing_m) {
  return texel_m(level) <= spacing_m ? 0.0 : 0.25 * texel_m(level);
}

// The texels whose middles lie in [low, high) along an axis.
struct Range {
  int first, end;
};
Range middles_in(double low_m, double high_m, double size_m) {
  return {static_cast<int>(std::ceil(low_m / size_m - 0.5)),
          static_cast<int>(std::ceil(high_m / size_m - 0.5))};
}

// Nearer texels are those of the finer level, but for the ones that are blended with its neighbours.
double nearest_m(int level) {
  if (level == 0) return -1.0;
  const double finer_half_m = 0.5 * texel_m(level - 1) * kSide;
  return fade_end_m(finer_half_m) - 2.0 * texel_m(level);
}

}  // namespace

TreadWindow::TreadWindow() : image_(layouts::kTreadLevels * kTexels) {}

void TreadWindow::paint(const Treading& treading, glm::dvec2 eye_m) {
  if (treading.revision() == revision_ && eye_m == centre_m_) return;
  revision_ = treading.revision();
  centre_m_ = eye_m;
  for (const Block& block : painted_) {
    for (int row = block.first_row; row < block.end_row; ++row) {
      for (int column = block.first_column; column < block.end_column; ++column)
        image_[index_of(block.level, row, column)] = {};
    }
    mark(block);
  }
  painted_.clear();

  const std::vector<PageIndex> pages = pages_around(treading);
  std::vector<Block> blocks(pages.size() * layouts::kTreadLevels);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
    blocks[n] =
        paint_page(treading, pages[n / layouts::kTreadLevels], static_cast<int>(n % layouts::kTreadLevels));
  });
  for (const Block& block : blocks) {
    if (block.first_row >= block.end_row) continue;
    painted_.push_back(block);
    mark(block);
  }
}

void TreadWindow::mark(const Block& block) {
  for (int row = block.first_row; row < block.end_row; ++row)
    is_changed_[static_cast<std::size_t>(block.level)][static_cast<std::size_t>(wrapped(row, kSide))] = true;
}

std::vector<TreadWindow::Rows> TreadWindow::take_changed() {
  std::vector<Rows> changed;
  for (int level = 0; level < layouts::kTreadLevels; ++level) {
    auto& rows = is_changed_[static_cast<std::size_t>(level)];
    for (int first = 0; first < kSide;) {
      int end = first;
      while (end < kSide && rows[static_cast<std::size_t>(end)]) ++end;
      if (end > first) changed.push_back({level, first, end - first});
      first = end + 1;
    }
    rows.fill(false);
  }
  return changed;
}

std::size_t TreadWindow::index_of(int level, int row, int column) {
  return static_cast<std::size_t>(level) * kTexels + torus_index(column, row, kSide);
}

// Those with trodden nodes within the last window, and their neighbours, whose texels may lie next to such
// nodes.
std::vector<PageIndex> TreadWindow::pages_around(const Treading& treading) const {
  const double spacing_m = treading.settings().spacing_m;
  const double most_m =
      fade_end_m(0.5 * texel_m(layouts::kTreadLevels - 1) * kSide) + 2.0 * kPageNodes * spacing_m;
  const PageIndex low = page_of(square_of(centre_m_ - most_m, spacing_m).south_west);
  const PageIndex high = page_of(square_of(centre_m_ + most_m, spacing_m).south_west);
  std::vector<PageIndex> pages;
  treading.state().wear.for_pages(low, high, [&](PageIndex page, const auto&) {
    for (int j = page.j - 1; j <= page.j + 1; ++j) {
      for (int i = page.i - 1; i <= page.i + 1; ++i) pages.push_back({.j = j, .i = i});
    }
  });
  std::ranges::sort(pages);
  const auto repeated = std::ranges::unique(pages);
  pages.erase(repeated.begin(), repeated.end());
  return pages;
}

// A texel takes the mean of 2 × 2 places in it, or what lies at its middle where nodes are no closer than
// texels.
TreadWindow::Block TreadWindow::paint_page(const Treading& treading, PageIndex page, int level) {
  const double spacing_m = treading.settings().spacing_m;
  const glm::dvec2 low_m = spacing_m * glm::dvec2(page.south_west().i, page.south_west().j);
  const double side_m = spacing_m * kPageNodes;
  const double size_m = texel_m(level), half_m = 0.5 * size_m * kSide;
  const bool is_last = level + 1 == layouts::kTreadLevels;
  // Beyond the place where the next window takes over lies what the outermost texels are blended with.
  const double end_m = fade_end_m(half_m), most_m = is_last ? end_m : end_m + size_m;
  const double start_m = fade_start_m(half_m), least_m = nearest_m(level);
  const auto distance_m = [&](glm::dvec2 place_m) {
    const glm::dvec2 away_m = glm::abs(place_m - centre_m_);
    return std::max(away_m.x, away_m.y);
  };
  if (distance_m(glm::clamp(centre_m_, low_m, low_m + side_m)) >= most_m) return {};
  if (distance_m(low_m + 0.5 * side_m) + 0.5 * side_m < least_m) return {};

  thread_local PageNodes nodes;
  nodes.read(treading, page, aside_m_of(level, spacing_m));
  if (nodes.are_at_rest()) return {};
  // No farther than the window reaches, or texels of both ends would share a place in the torus.
  const auto texels_along = [&](double from_m, double centre_m) {
    return middles_in(std::max(from_m, centre_m - most_m), std::min(from_m + side_m, centre_m + most_m),
                      size_m);
  };
  const Range rows = texels_along(low_m.y, centre_m_.y), columns = texels_along(low_m.x, centre_m_.x);
  std::vector<Taps> across;
  for (int column = columns.first; column < columns.end; ++column)
    across.push_back(nodes.column_at(size_m * (column + 0.5)));
  const auto share_at = [&](glm::dvec2 middle_m) {
    const double away_m = distance_m(middle_m);
    if (away_m >= most_m || away_m < least_m) return 0.0f;
    return is_last && away_m > start_m ? static_cast<float>((end_m - away_m) / (end_m - start_m)) : 1.0f;
  };
  std::vector<float> shares(across.size());
  std::vector<glm::vec4> blended(static_cast<std::size_t>(nodes.side()));
  std::vector<TreadTexel> texels(across.size());
  for (int row = rows.first; row < rows.end; ++row) {
    const double y_m = size_m * (row + 0.5);
    for (int column = columns.first; column < columns.end; ++column)
      shares[static_cast<std::size_t>(column - columns.first)] = share_at({size_m * (column + 0.5), y_m});
    paint_row(nodes, nodes.row_at(y_m), across, shares, blended, texels);
    for (int column = columns.first; column < columns.end; ++column)
      image_[index_of(level, row, column)] = texels[static_cast<std::size_t>(column - columns.first)];
  }
  return {level, rows.first, rows.end, columns.first, columns.end};
}

}  // namespace prairie
