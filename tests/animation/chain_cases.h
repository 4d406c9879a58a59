// Chains for tests: relaxed arcs, their energy in double, and parameters from all that a scene file allows.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <random>

#include "animation/inertial_chains.h"

namespace prairie {

/// Directions of relaxed segments: a foot and from there an arc about `axis` ⟂ foot.
struct Arc {
  glm::dvec3 foot{0.0, 0.0, 1.0};
  glm::dvec3 axis{0.0, 1.0, 0.0};
  double turning = 0.0;
  std::array<glm::dvec3, 4> directions() const;
};

/// A foot that leans from the vertical towards `azimuth_rad`, an arc that goes on bending at `bend_rad` to
/// that.
Arc leaning_arc(double lean_rad, double azimuth_rad, double turning_rad, double bend_rad);

ChainVectors chain_vectors(const std::array<glm::dvec3, 4>& v);
std::array<glm::dvec3, 4> vectors_of(const ChainVectors& v);

/// Tip relative to the root, as a share of the length of the straight chain.
glm::dvec3 tip_share(const ChainVectors& directions);

/// Kinetic energy, energy of springs and potential of weight, in m g l.
double energy_of(const ChainVectors& rest, const ChainMotion& motion, const ChainTraits& traits);

double uniform(std::mt19937& random, double least, double most);
double log_uniform(std::mt19937& random, double least, double most);
glm::dvec3 unit_vector(std::mt19937& random);

/// Anything that scene files can ask for: heights of 5 mm to 6 m and stiffnesses with spreads of 0.95, any
/// mass, width and damping ratios from 0 to 2.
ChainTraits any_traits(std::mt19937& random);

}  // namespace prairie
