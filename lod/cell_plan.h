// The 3D blades of a frame: of each cell in view an upper bound of how many are drawn, and with which mesh
// (docs/design.md, D3). Near the eye cells are culled and thinned by quarters.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "generator/cell_table.h"
#include "generator/meadow.h"
#include "lod/camera.h"
#include "lod/frame_plan.h"
#include "lod/tile_search.h"

namespace prairie {

/// What a tile in view takes at most: four cells made ready, once more in the plan, and its strips.
std::size_t bytes_per_tile(const PlantingLattice& lattice);

class CellPlan {
 public:
  /// Up to what distance from the eye cells are planned by quarters where the camera thins.
  static double quarters_far_m(const LodCoefficients& lod, const Camera& camera);

  /// For a plan whose camera, eye and coefficients are set; `longest_m`: of each species' blades. All of them
  /// have to outlive it.
  CellPlan(const Meadow& meadow, const PlantingLattice& lattice, std::span<const double> longest_m,
           const TileSearch& search, double quarters_far_m, FramePlan& plan);

  /// Plans the cells of a tile in view that has morphed so far.
  void add_tile(TileId tile, float morph);
  /// Writes all cells into the plan, grouped by mesh.
  void finish();

 private:
  static constexpr std::array<std::uint32_t, 4> kSegments{8, 4, 2, 1};

  /// A cell in view: where it stands and what its ground is like.
  struct CellGround {
    glm::dvec2 min_m;  // in the scene
    std::array<float, 9> heights_m;
    AlignedBox box;
  };

  void add_cell(TileId tile, int cell, float morph);
  CellGround ground_of(TileId tile, int cell) const;
  bool add_planted(const PlantedCell& planted, const CellGround& ground, DrawnCell drawn);
  bool add_roots(const AlignedBox& roots, const CellGround& ground, DrawnCell drawn);
  std::size_t segment_class(double blade_pixels) const;

  const Meadow& meadow_;
  const PlantingLattice& lattice_;
  std::span<const double> longest_m_;
  const TileSearch& search_;
  double quarters_far_m_;
  Camera lod_camera_;  // at the eye for which tiers are chosen
  FramePlan& plan_;
  CellTables tables_;  // of the cell being planned
  std::array<std::array<std::vector<DrawnCell>, kSegments.size()>, 2> hermite_and_spline_;
};

}  // namespace prairie
