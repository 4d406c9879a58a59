#include "lod/tile_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "files/error.h"

namespace prairie {

TileSearch::TileSearch(const Meadow& meadow, const Camera& camera, glm::dvec3 centre_m, double far_m,
                       double blade_m)
    : meadow_(meadow),
      camera_(camera),
      frustum_(camera),
      centre_m_(centre_m),
      far_m_(far_m),
      blade_m_(blade_m) {}

std::vector<SeenTile> TileSearch::tiles(std::size_t most_tiles) {
  most_tiles_ = most_tiles;
  int level = 0;
  const double reach_m = std::min(far_m_, 2.0 * glm::length(meadow_.extent_m) + far_from_field_m());
  while (std::ldexp(meadow_.tile_m, level) < reach_m && level < 24) ++level;
  const double side_m = std::ldexp(meadow_.tile_m, level);
  const int x = static_cast<int>(std::floor(centre_m_.x / side_m));
  const int y = static_cast<int>(std::floor(centre_m_.y / side_m));
  for (int row = y - 1; row <= y + 1; ++row) {
    for (int column = x - 1; column <= x + 1; ++column) visit(level, column, row);
  }
  std::stable_sort(found_.begin(), found_.end(),
                   [](const SeenTile& a, const SeenTile& b) { return a.distance_m < b.distance_m; });
  return std::move(found_);
}

AlignedBox TileSearch::box_of_cell(TileId tile, int cell) const {
  const glm::dvec2 min_m = tile_origin_m(meadow_, tile) + glm::dvec2(cell_offset_m(meadow_, cell));
  return box_of(min_m, min_m + meadow_.tile_m / kCellsPerSide);
}

double TileSearch::far_from_field_m() const {
  if (meadow_.repeats) return far_m_;
  const glm::dvec2 place_m(centre_m_);
  return glm::length(place_m - glm::clamp(place_m, glm::dvec2(0.0), meadow_.extent_m));
}

AlignedBox TileSearch::box_of(glm::dvec2 min_m, glm::dvec2 max_m) const {
  const HeightRange ground = meadow_.ground.range(min_m, max_m);
  return {glm::dvec3(min_m - blade_m_, ground.min_m),
          glm::dvec3(max_m + blade_m_, static_cast<double>(ground.max_m) + blade_m_)};
}

void TileSearch::visit(int level, int column, int row) {
  const double side_m = std::ldexp(meadow_.tile_m, level);
  const glm::dvec2 min_m = side_m * glm::dvec2(column, row);
  const glm::dvec2 max_m = min_m + side_m;
  if (!meadow_.repeats &&
      (max_m.x <= 0.0 || max_m.y <= 0.0 || min_m.x >= meadow_.extent_m.x || min_m.y >= meadow_.extent_m.y)) {
    return;
  }
  const AlignedBox box = box_of(min_m, max_m);
  if (!frustum_.may_see(box) || nearest_distance_m(box, centre_m_) >= far_m_) return;
  if (level == 0) {
    if (found_.size() == most_tiles_) {
      throw OverBudget("", "--max-memory", fmt::format("more than {} tiles in view", most_tiles_),
                       "a larger budget, a shorter lod.blade_distance_m or fewer tiles in view");
    }
    found_.push_back({{column, row}, box, nearest_distance_m(box, camera_.eye_m)});
    return;
  }
  for (int child = 0; child < 4; ++child) visit(level - 1, 2 * column + child % 2, 2 * row + child / 2);
}

}  // namespace prairie
