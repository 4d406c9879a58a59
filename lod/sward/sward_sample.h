// Sample blades of a species, cut into elements: what lod/sward/sward_response.h sums over. Blades are
// planted and posed by the kernels, on level ground. Taller ones are taken more often and count less, because
// seen at grazing angles a sward shows nothing but its tallest blades; each is turned about the vertical so
// that the tips of all point evenly all round.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "shaders/kernels/kernels.h"

namespace prairie {

/// Pieces of blades, ordered from the highest to the lowest; what lies below the ground is left out.
struct SwardElements {
  std::vector<float> height_m;
  std::vector<float> area_m2;  // one side of it, per blade of the species: sums to a blade's mean area
  std::vector<float> reach_m;  // area_m2 / |along|
  std::vector<float> along_x, along_y, along_z;    // derivative of the midrib
  std::vector<float> side_x, side_y, side_z;       // across the blade at rest
  std::vector<float> place;                        // along the blade: 0 foot, 1 tip
  std::vector<glm::vec3> root_albedo, tip_albedo;  // of the blade that it is a piece of
  std::size_t size() const { return height_m.size(); }
};

/// Level ground with some thousand blades of this species, thinly sown, so that hardly two share a tuft.
std::vector<Blade> sown_blades(const SpeciesParams& species);

/// The midrib of a blade at rest on level ground, as shaders/pass/grow.comp poses it.
Kernels::BladeCurve resting_curve(const Blade& blade);

SwardElements sward_elements(const SpeciesParams& species);

}  // namespace prairie
