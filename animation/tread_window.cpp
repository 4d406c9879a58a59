#include "animation/tread_window.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "animation/sway.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kTreadSide;
constexpr std::size_t kTexels = std::size_t{kSide} * kSide;

double texel_m(int level) {
  return static_cast<double>(layouts::kSwayFinestM) * layouts::kSwaySide / kSide *
         std::pow(static_cast<double>(layouts::kSwayCoarsening), level);
}

int wrapped(int i) {
  return ((i % kSide) + kSide) % kSide;
}

std::int8_t packed(float share) {
  const float steps = 127.0f * std::clamp(share, -1.0f, 1.0f);
  return static_cast<std::int8_t>(steps + (steps < 0.0f ? -0.5f : 0.5f));  // lround, which is a call, takes as long as the rest
}

TreadTexel texel_of(glm::vec4 tread) {
  const glm::vec3 share = glm::vec3(tread) / layouts::kTreadMostRad;
  return {packed(share.x), packed(share.y), packed(share.z), packed(tread.w)};
}

/// What two texels of a row or column lie between: nodes `from` and the next one.
struct Between {
  int from = 0;
  float share = 0.0f;
};

/// A page's nodes with some around them, to be sampled quickly.
class PageNodes {
 public:
  void read(const Treading& treading, PageIndex page, int margin) {
    spacing_m_ = treading.settings().spacing_m;
    side_ = kPageNodes + 2 * margin;
    south_west_ = {page.south_west().i - margin, page.south_west().j - margin};
    nodes_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    treading.read({south_west_.i, south_west_.j, side_, side_}, nodes_);
  }

  Between column_at(double x_m) const { return between(x_m, south_west_.i); }
  Between row_at(double y_m) const { return between(y_m, south_west_.j); }

  /// (lean east, lean north, tilt, wear), bilinear.
  glm::vec4 sample(Between column, Between row) const {
    const glm::vec4* south = &nodes_[static_cast<std::size_t>(row.from * side_ + column.from)];
    const glm::vec4* north = south + side_;
    const glm::vec4 low = south[0] + (south[1] - south[0]) * column.share;
    const glm::vec4 high = north[0] + (north[1] - north[0]) * column.share;
    return low + (high - low) * row.share;
  }

 private:
  Between between(double position_m, int first) const {
    const double nodes = position_m / spacing_m_;
    const double below = std::floor(nodes);
    const Between found{static_cast<int>(below) - first, static_cast<float>(nodes - below)};
    assert(found.from >= 0 && found.from + 1 < side_);
    return found;
  }

  double spacing_m_ = 0.0;
  int side_ = 0;
  NodeIndex south_west_;
  std::vector<glm::vec4> nodes_;
};

// How far from its middle a texel samples: not at all where nodes are no closer than texels.
double aside_m_of(int level, double spacing_m) {
  return texel_m(level) <= spacing_m ? 0.0 : 0.25 * texel_m(level);
}

// The texels whose middles lie in [low, high) along an axis.
struct Range {
  int first, end;
};
Range middles_in(double low_m, double high_m, double size_m) {
  return {static_cast<int>(std::ceil(low_m / size_m - 0.5)), static_cast<int>(std::ceil(high_m / size_m - 0.5))};
}

}  // namespace

TreadWindow::TreadWindow() : image_(layouts::kTreadLevels * kTexels) {}

void TreadWindow::paint(const Treading& treading, glm::dvec2 eye_m) {
  for (const std::uint32_t index : painted_) image_[index] = {};
  painted_.clear();
  centre_m_ = eye_m;
  // Worn nodes lie down without having been pressed lately, so that both fields have a say.
  std::set<PageIndex> indices;
  for (const auto& [page, nodes] : treading.state().nodes.pages()) indices.insert(page);
  for (const auto& [page, nodes] : treading.state().wear.pages()) indices.insert(page);
  const std::vector<PageIndex> pages(indices.begin(), indices.end());
  std::vector<std::vector<Painted>> painted(pages.size());
  tbb::parallel_for(std::size_t{0}, pages.size(), [&](std::size_t n) {
    for (int level = 0; level < layouts::kTreadLevels; ++level) paint_page(treading, pages[n], level, painted[n]);
  });
  // Neighbours paint the texels between them alike.
  for (const std::vector<Painted>& texels : painted) {
    for (const Painted& one : texels) {
      image_[one.index] = one.texel;
      painted_.push_back(one.index);
    }
  }
}

// A texel takes the mean of 2 × 2 places in it, or what lies at its middle where nodes are no closer than texels.
void TreadWindow::paint_page(const Treading& treading, PageIndex page, int level, std::vector<Painted>& painted) const {
  const double spacing_m = treading.settings().spacing_m;
  const glm::dvec2 low_m = spacing_m * glm::dvec2(page.south_west().i, page.south_west().j);
  const double side_m = spacing_m * kPageNodes;
  const double size_m = texel_m(level), half_m = 0.5 * size_m * kSide;
  const double most_m = fade_end_m(half_m), start_m = fade_start_m(half_m);
  // Nearer texels are those of the finer level, but for the ones that are blended with its neighbours.
  const double least_m = level == 0 ? -1.0 : fade_end_m(half_m / static_cast<double>(layouts::kSwayCoarsening)) - 2.0 * size_m;
  const auto distance_m = [&](glm::dvec2 place_m) {
    const glm::dvec2 away_m = glm::abs(place_m - centre_m_);
    return std::max(away_m.x, away_m.y);
  };
  const glm::dvec2 middle_m = low_m + 0.5 * side_m;
  if (distance_m(glm::clamp(centre_m_, low_m, low_m + side_m)) >= most_m) return;
  if (distance_m(middle_m) + 0.5 * side_m + 2.0 * spacing_m < least_m) return;

  const double aside_m = aside_m_of(level, spacing_m);
  PageNodes nodes;
  nodes.read(treading, page, 2 + static_cast<int>(std::ceil(aside_m / spacing_m)));
  // Texels beside the page are reached by its outermost nodes.
  const Range rows = middles_in(low_m.y - spacing_m, low_m.y + side_m, size_m);
  const Range columns = middles_in(low_m.x - spacing_m, low_m.x + side_m, size_m);
  struct Places {
    Between middle, before, after;
  };
  std::vector<Places> across;
  for (int column = columns.first; column < columns.end; ++column) {
    const double x_m = size_m * (column + 0.5);
    across.push_back({nodes.column_at(x_m), nodes.column_at(x_m - aside_m), nodes.column_at(x_m + aside_m)});
  }
  const bool is_last = level + 1 == layouts::kTreadLevels;
  for (int row = rows.first; row < rows.end; ++row) {
    const double y_m = size_m * (row + 0.5);
    const Places up{nodes.row_at(y_m), nodes.row_at(y_m - aside_m), nodes.row_at(y_m + aside_m)};
    for (int column = columns.first; column < columns.end; ++column) {
      const double away_m = distance_m({size_m * (column + 0.5), y_m});
      if (away_m >= most_m || away_m < least_m) continue;
      const Places& at = across[static_cast<std::size_t>(column - columns.first)];
      glm::vec4 tread;
      if (aside_m > 0.0) {
        tread = 0.25f * (nodes.sample(at.before, up.before) + nodes.sample(at.after, up.before) +
                         nodes.sample(at.before, up.after) + nodes.sample(at.after, up.after));
      } else {
        tread = nodes.sample(at.middle, up.middle);
      }
      if (is_last && away_m > start_m) tread *= static_cast<float>((most_m - away_m) / (most_m - start_m));
      const TreadTexel texel = texel_of(tread);
      if (texel == TreadTexel{}) continue;
      painted.push_back({static_cast<std::uint32_t>(static_cast<std::size_t>(level) * kTexels +
                                                    static_cast<std::size_t>(wrapped(row)) * kSide +
                                                    static_cast<std::size_t>(wrapped(column))),
                         texel});
    }
  }
}

}  // namespace prairie
