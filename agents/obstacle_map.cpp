#include "agents/obstacle_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/plan_cell.h"

namespace prairie {
namespace {

constexpr double kCellM = 4.0;

}  // namespace

ObstacleMap::ObstacleMap(std::vector<Footprint> footprints, double reach_m)
    : footprints_(std::move(footprints)) {
  std::vector<std::pair<std::int64_t, std::uint32_t>> entries;
  const double half_diagonal_m = kCellM * 0.70710678118654752;
  for (std::uint32_t index = 0; index < footprints_.size(); ++index) {
    const FootprintBox box = box_of(footprints_[index]);
    boxes_.push_back(box);
    const PlanCell low = plan_cell(box.low_m - reach_m, kCellM),
                   high = plan_cell(box.high_m + reach_m, kCellM);
    for (int j = low.j; j <= high.j; ++j) {
      for (int i = low.i; i <= high.i; ++i) {
        // A long wall lies in few of the cells of its box.
        const Disc cell{kCellM * (glm::dvec2(i, j) + 0.5), half_diagonal_m};
        if (plan_distance(cell, footprints_[index]).distance_m <= reach_m)
          entries.emplace_back(key_of({i, j}), index);
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  for (const auto& [key, index] : entries) {
    const auto at = static_cast<std::uint32_t>(indices_.size());
    if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, at, at});
    indices_.push_back(index);
    ++cells_.back().end;
  }
}

std::span<const std::uint32_t> ObstacleMap::near(glm::dvec2 position_m) const {
  const std::int64_t key = key_of(plan_cell(position_m, kCellM));
  const auto found = std::lower_bound(cells_.begin(), cells_.end(), key,
                                      [](const Cell& cell, std::int64_t k) { return cell.key < k; });
  if (found == cells_.end() || found->key != key) return {};
  return std::span(indices_).subspan(found->first, found->end - found->first);
}

}  // namespace prairie
