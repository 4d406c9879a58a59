// The scene of the bench `scale`: a square kilometre of two grasses, 1000 blades per m² in all, and a walk
// through it at eye height.
#pragma once

#include "bench/scale_ground.h"
#include "lod/camera.h"
#include "world/world.h"

namespace prairie {

struct ScaleVariant {
  double density_factor = 1.0;  // of both grasses
  bool repeats = false;         // the ground goes on without end
  int walkers = 0;              // before the eye, at least most of them in its view
  bool windy = false;           // a fresh breeze with its turbulence, and a gust on its way
};

/// Throws what World throws.
World scale_world(const ScaleGround& ground, const ScaleVariant& variant);

/// Blades that planting gives on average, on one period of the ground.
double expected_blades(const World& world);

inline constexpr int kWalkFrames = 100;
inline constexpr double kWalkFrameS = 1.0 / 30.0;

/// What the walker sees in the n-th frame; n may be negative.
Camera walk_camera(const World& world, int frame);

}  // namespace prairie
