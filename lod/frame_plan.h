// What one frame draws: which cells are seen, how many of their blades, which tiles stand in strips, and
// which patches of ground. Made by lod/planner.h, drawn by render/; the renderer decides nothing about
// plants.
#pragma once

#include <cstdint>
#include <vector>

#include "lod/camera.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// In which representation tiles are drawn; `kAuto` lets each tile's distance decide. `kSpline` and
/// `kHermite` draw every planted blade at any distance, `kStrip` and `kFlat` none.
enum class Tier { kAuto, kSpline, kHermite, kStrip, kFlat };

/// A run of `FramePlan::cells` whose blades have the same mesh.
struct CellGroup {
  bool is_spline = false;  // else Hermite blades
  std::uint32_t segments = 1;
  std::uint32_t first_cell = 0;
  std::uint32_t cell_count = 0;
};

/// How far a tile has morphed from 3D blades (0) to strips (1).
struct TileMorph {
  int i = 0;
  int j = 0;
  float morph = 0.0f;
};

/// Sides of a ground patch along which the neighbour is twice as coarse.
enum PatchSide : std::uint8_t { kWest = 1, kEast = 2, kSouth = 4, kNorth = 8 };

/// A square of ground, drawn as kPatchQuads × kPatchQuads quads of side kFinestQuadM · 2^level.
struct GroundPatch {
  int level = 0;
  int column = 0;  // of its south-west corner, in patches of its level from the scene's origin
  int row = 0;
  std::uint8_t coarser_sides = 0;
};

inline constexpr int kPatchQuads = 16;
inline constexpr double kFinestQuadM = 0.5;

/// Side of a patch, metres.
double patch_side_m(int level);

struct FramePlan {
  Camera camera;
  glm::dvec3 lod_eye_m{0.0};  // for which tiers were chosen
  LodCoefficients lod{};
  std::vector<DrawnCell> cells;   // grouped by mesh, front to back in each group
  std::vector<CellGroup> groups;  // splines first, most segments first
  std::vector<float> tables;      // what the cells' table words index
  std::vector<StripTile> strips;  // near ones first
  std::uint32_t near_strips =
      0;  // how many of them follow the ground in kStripQuads quads a side; the rest in one
  std::vector<TileMorph> morphs;             // of tiles in view, where distance decides
  std::vector<GroundPatch> ground;           // front to back
  std::uint64_t blades_planted_in_view = 0;  // of tiles in strips: the maps' expectation
  std::uint64_t blades_drawn = 0;            // as 3D blades, at most
  std::uint64_t blades_in_strips = 0;        // that strips stand for
};

}  // namespace prairie
