// The wind of the scene: the sum (G03 §4.1) of a mean wind, the turbulence that it carries, primitives, and
// the camera's wake. One field for all tiers: they read the same nodes.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "animation/camera_wake.h"
#include "animation/mean_wind.h"
#include "animation/node_block.h"
#include "animation/noise_wind.h"
#include "animation/wind_primitives.h"

namespace prairie {

struct Wind {
  MeanWind mean;
  std::optional<NoiseWind> noise;         // none: no turbulence, or that of a replayed series alone
  std::vector<WindPrimitive> primitives;  // checked where they come in (animation/wind_primitives.h)
  std::optional<CameraWake> wake;
};

/// m/s, towards where it blows; a pure function but for the wake, which is that of its last step.
glm::vec2 wind_m_per_s(const Wind& wind, glm::dvec2 position_m, double time_s);

/// A block of nodes for a texture.
using WindNodes = NodeBlock;

/// `side` × `side` nodes around a place, which follow it node by node.
WindNodes wind_nodes_around(glm::dvec2 centre_m, int side, double spacing_m);

/// The wind at every node, row by row from south-west, as wind_m_per_s has it; primitives cost nothing where
/// they do not reach.
void fill_wind(const Wind& wind, const WindNodes& nodes, double time_s, std::span<glm::vec2> out_m_per_s);

}  // namespace prairie
