// A grid of virtual blades that follows the camera (B11 §3.3): one upright inertial blade of each species in
// the middle of each texel. What they tell of the wind and of inertia is all that drawn blades need to move
// (shaders/kernels/ chain_virtual.glsl), so that nothing is stored per drawn blade.
//
// Texels lie on a fixed lattice of the ground, texel (i, j) covering [i, i + 1) × [j, j + 1) · texel_m; the
// window of side × side of them is kept as a torus, (i mod side, j mod side), row by row from the south. A
// texture of them that repeats is sampled at position / (side · texel_m), wherever the window stands; only
// within half a texel of the window's edge it mixes what lies on opposite sides.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "animation/inertial_chains.h"

namespace prairie {

/// What drawn blades find in a texel; see texel_load and texel_tip in chain_virtual.glsl.
struct VirtualTexel {
  std::array<glm::vec4, 4> segments;
};

class VirtualBlades {
 public:
  /// A virtual blade for each species: half a segment of a mean blade, its stiffness, damping and drag.
  /// `side` texels of `texel_m` each way, around `eye_m` (east, north).
  VirtualBlades(std::vector<ChainTraits> species, int side, double texel_m, glm::dvec2 eye_m);

  int side() const { return side_; }
  double texel_m() const { return texel_m_; }
  std::size_t texel_count() const {
    return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  }
  std::size_t species_count() const { return species_.size(); }

  /// South-western texel of the window: (i, j) · texel_m is its own corner.
  glm::ivec2 corner() const { return corner_; }

  /// The middle of the texel that lies at `index` of the torus now.
  glm::dvec2 middle_m(std::size_t index) const;

  /// Centres the window on the eye. Blades of texels that are new move as the nearest that stays; where none
  /// stays, they stand still and upright.
  void follow(glm::dvec2 eye_m);

  /// Blades of a texel become so many times as stiff as their species; each keeps its place and its damping
  /// ratio.
  void stiffen(std::size_t index, float factor);

  /// Moves all blades on by `dt_s` in a wind for each texel, by index, m/s.
  void step(std::span<const glm::vec3> wind_m_per_s, float dt_s);

  /// What drawn blades find, of the blades as they stand and move in a wind.
  void feel(std::span<const glm::vec3> wind_m_per_s);

  /// Lets all blades find their place in a constant wind.
  void settle(std::span<const glm::vec3> wind_m_per_s);

  /// By index.
  std::span<const VirtualTexel> texels(std::size_t species) const { return species_[species].texels; }

  /// Bilinear between the middles of texels, as a repeating texture is sampled.
  VirtualTexel at(std::size_t species, glm::dvec2 position_m) const;

  /// The inertial blade of a texel.
  ChainMotion motion(std::size_t species, std::size_t index) const {
    return species_[species].blades.motion(index);
  }
  void set_motion(std::size_t species, std::size_t index, const ChainMotion& motion) {
    species_[species].blades.set_motion(index, motion);
  }

 private:
  struct Stand {
    float stiffness;  // of the species
    InertialChains blades;
    std::vector<VirtualTexel> texels;
  };
  /// Sets the wind, calls `move(blades, first block, end)` for runs of blocks at the same time, and finds
  /// their texels.
  template <class Move>
  void for_blocks(std::span<const glm::vec3> wind_m_per_s, Move move);
  glm::ivec2 texel_at(std::size_t index) const;  // of the lattice

  int side_;
  double texel_m_;
  glm::ivec2 corner_;
  std::vector<Stand> species_;
};

}  // namespace prairie
