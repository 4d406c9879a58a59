// Smooth noise for made-up ground and drifts of grass: random values at the nodes of a lattice, quintic
// between them. A pure function of (seed, position) in plain arithmetic, so that it gives the same bits
// everywhere.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace prairie {

/// In −1…1, first and second derivatives continuous, features about one unit wide.
double lattice_noise(std::uint64_t seed, glm::dvec2 position);

/// Three octaves, each half as wide and half as strong as the one before, in −1…1.
double layered_noise(std::uint64_t seed, glm::dvec2 position);

}  // namespace prairie
