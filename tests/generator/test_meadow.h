// Meadows for tests: small, made up, the same on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>

#include "generator/meadow.h"

namespace prairie {

/// A grass of middling height whose every attribute varies.
Species test_grass();

/// One channel, node values from their positions in the scene.
NodeGrid grid_from(const GridFrame& frame, const std::function<double(glm::dvec2)>& value);

/// Nodes of `spacing_m` from (0, 0) to (extent_m, extent_m), which is a whole number of spacings.
GridFrame square_frame(double extent_m, double spacing_m);

/// [0, 1) from two numbers, the same everywhere.
double unit_noise(std::uint64_t seed, std::int64_t x, std::int64_t y);

/// Level ground of extent_m × extent_m with one species of this density.
Meadow level_meadow(double extent_m, NodeGrid density_per_m2);

// Densities over a square of `extent_m` from the origin, mean about `mean_per_m2`.
NodeGrid uniform_density(double per_m2);
/// Hills and valleys 20 m long on nodes 4 m apart, between 0.4 and 1.6 of the mean.
NodeGrid smooth_density(double extent_m, double mean_per_m2);
/// Neighbouring nodes, 1 m apart, between 0.1 and 1.9 of the mean at random.
NodeGrid steep_density(double extent_m, double mean_per_m2);
/// The same with nodes 0.25 m apart.
NodeGrid quarter_metre_density(double extent_m, double mean_per_m2);

/// Three species over feature maps and steep ground: every table that planting knows.
Meadow rich_meadow(double extent_m);

}  // namespace prairie
