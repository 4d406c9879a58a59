// Which share of a frame's ground stands in which tier, read off the picture itself: a tinted frame against
// the plain one.
#pragma once

#include "lod/camera.h"
#include "render/frame/renderer.h"

namespace prairie {

/// Shares of the pixels that are not sky; they add up to 1. Where the flat tier shows through to the floor, a
/// pixel counts by its cover.
struct TierShares {
  double spline = 0.0;
  double hermite = 0.0;
  double strip = 0.0;
  double flat = 0.0;
  double floor = 0.0;  // soil and litter between blades, which belongs to no tier
};

TierShares tier_shares(Renderer& renderer, const Camera& camera);

}  // namespace prairie
