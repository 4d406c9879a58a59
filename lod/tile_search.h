// Finds the tiles and cells that a camera may see, by walking squares of tiles from coarse to fine (RG, "View
// Frustum Culling").
#pragma once

#include <vector>

#include "generator/meadow.h"
#include "generator/tiles.h"
#include "lod/camera.h"
#include "lod/frustum.h"

namespace prairie {

/// A tile in view.
struct SeenTile {
  TileId id;
  AlignedBox box;     // holds its ground and its blades
  double distance_m;  // of the box from the camera
};

class TileSearch {
 public:
  /// Tiles within `far_m` of `centre_m`, whose blades are at most `blade_m` long.
  TileSearch(const Meadow& meadow, const Camera& camera, glm::dvec3 centre_m, double far_m, double blade_m);

  /// Front to back. Throws OverBudget where there are more than `most_tiles`.
  std::vector<SeenTile> tiles(std::size_t most_tiles);

  bool sees(const AlignedBox& box) const { return frustum_.may_see(box); }
  /// Holds a cell's ground and blades.
  AlignedBox box_of_cell(TileId tile, int cell) const;

 private:
  void visit(int level, int column, int row);
  AlignedBox box_of(glm::dvec2 min_m, glm::dvec2 max_m) const;
  double far_from_field_m() const;

  const Meadow& meadow_;
  const Camera& camera_;
  Frustum frustum_;
  glm::dvec3 centre_m_;
  double far_m_;
  double blade_m_;
  std::vector<SeenTile> found_;
  std::size_t most_tiles_ = 0;
};

}  // namespace prairie
