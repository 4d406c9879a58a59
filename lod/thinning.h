// How many of a cell's blades a frame needs: the bound on B11's keep share 1 − F over the cell
// (shaders/kernels/weight.glsl), and the coefficients that each quality level gives it.
#pragma once

#include <cstdint>
#include <span>

#include "lod/camera.h"
#include "lod/frame_plan.h"
#include "lod/frustum.h"
#include "lod/quality.h"
#include "maps/height_range.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// Coefficients of B11's weight function (§2.2) and of the tiers' bands, for what the person chose and the
/// camera's pixels. `blade_distance_m`: beyond it only the flat tier stands.
LodCoefficients tier_coefficients(Tier tier, Quality quality, double blade_distance_m, const Camera& camera);

/// Lowest and highest height, to a rounding error, that the ground of a cell can have: of the biquadratic
/// surface through 3 × 3 heights (shaders/kernels/cell_ground.glsl).
HeightRange ground_range(std::span<const float> heights_m);

/// The ground of a cell as seen from an eye.
struct CellView {
  AlignedBox box;                    // of the cell's ground
  std::span<const float> heights_m;  // 3 × 3, row by row from south
  double side_m;
};

/// An upper bound of keep_share over the cell, for blades of a mean width.
double keep_bound(const LodCoefficients& lod, const Camera& camera, const CellView& cell, float width_m);

/// How many blades of the cell can be drawn: those whose rank (k + ξ)/N is below the bound.
std::uint32_t drawn_bound(const PlantedCell& cell, double keep);

}  // namespace prairie
