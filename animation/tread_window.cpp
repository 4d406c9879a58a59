#include "animation/tread_window.h"

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
  return static_cast<std::int8_t>(std::lround(127.0f * std::clamp(share, -1.0f, 1.0f)));
}

TreadTexel texel_of(glm::vec4 tread) {
  const glm::vec3 share = glm::vec3(tread) / layouts::kTreadMostRad;
  return {packed(share.x), packed(share.y), packed(share.z), packed(tread.w)};
}

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

  /// (lean east, lean north, tilt, wear), bilinear.
  glm::vec4 sample(glm::dvec2 position_m) const {
    const NodeSquare square = square_of(position_m, spacing_m_);
    const int column = square.south_west.i - south_west_.i, row = square.south_west.j - south_west_.j;
    assert(column >= 0 && row >= 0 && column + 1 < side_ && row + 1 < side_);
    const glm::vec4* south = &nodes_[static_cast<std::size_t>(row * side_ + column)];
    const glm::vec4* north = south + side_;
    const glm::vec4 low = south[0] + (south[1] - south[0]) * square.east;
    const glm::vec4 high = north[0] + (north[1] - north[0]) * square.east;
    return low + (high - low) * square.north;
  }

  /// Of four places, aside of the middle both ways.
  glm::vec4 mean_around(glm::dvec2 middle_m, double aside_m) const {
    glm::vec4 sum(0.0f);
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)})
      sum += sample(middle_m + aside_m * corner);
    return 0.25f * sum;
  }

  bool holds_some() const { return side_ > 0; }

 private:
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
  std::set<PageIndex> pages;
  for (const auto& [page, nodes] : treading.state().nodes.pages()) pages.insert(page);
  for (const auto& [page, nodes] : treading.state().wear.pages()) pages.insert(page);
  for (const PageIndex page : pages) paint_page(treading, page);
}

// A texel takes the mean of 2 × 2 places in it, or what lies at its middle where nodes are no closer than texels.
void TreadWindow::paint_page(const Treading& treading, PageIndex page) {
  const double spacing_m = treading.settings().spacing_m;
  const glm::dvec2 low_m = spacing_m * glm::dvec2(page.south_west().i, page.south_west().j);
  const double side_m = spacing_m * kPageNodes;
  PageNodes nodes;
  for (int level = 0; level < layouts::kTreadLevels; ++level) {
    const double size_m = texel_m(level), half_m = 0.5 * size_m * kSide;
    const double most_m = fade_end_m(half_m), start_m = fade_start_m(half_m);
    const glm::dvec2 nearest_m = glm::clamp(centre_m_, low_m, low_m + side_m) - centre_m_;
    if (std::max(std::abs(nearest_m.x), std::abs(nearest_m.y)) >= most_m) continue;
    const double aside_m = aside_m_of(level, spacing_m);
    if (!nodes.holds_some())
      nodes.read(treading, page, 2 + static_cast<int>(std::ceil(aside_m_of(layouts::kTreadLevels - 1, spacing_m) / spacing_m)));
    // Texels beside the page are reached by its outermost nodes.
    const Range rows = middles_in(low_m.y - spacing_m, low_m.y + side_m, size_m);
    const Range columns = middles_in(low_m.x - spacing_m, low_m.x + side_m, size_m);
    for (int row = rows.first; row < rows.end; ++row) {
      for (int column = columns.first; column < columns.end; ++column) {
        const glm::dvec2 middle_m = size_m * (glm::dvec2(column, row) + 0.5);
        const glm::dvec2 away_m = glm::abs(middle_m - centre_m_);
        const double distance_m = std::max(away_m.x, away_m.y);
        if (distance_m >= most_m) continue;
        glm::vec4 tread = aside_m > 0.0 ? nodes.mean_around(middle_m, aside_m) : nodes.sample(middle_m);
        const bool is_last = level + 1 == layouts::kTreadLevels;
        if (is_last && distance_m > start_m)
          tread *= static_cast<float>((most_m - distance_m) / (most_m - start_m));
        const TreadTexel texel = texel_of(tread);
        if (texel == TreadTexel{}) continue;
        const std::size_t index = static_cast<std::size_t>(level) * kTexels +
                                  static_cast<std::size_t>(wrapped(row)) * kSide +
                                  static_cast<std::size_t>(wrapped(column));
        image_[index] = texel;
        painted_.push_back(static_cast<std::uint32_t>(index));
      }
    }
  }
}

}  // namespace prairie
