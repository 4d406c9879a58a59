// Wind and inertia of virtual blades (B11 §3.3) for all that is seen: windows of rising texel size around the
// eye (animation/virtual_blades.h), as the texture that all tiers read; they fade into one another
// (animation/eye_windows.h).
//
// Layers of the texture, each side × side texels of four floats, rows from the torus' first: for each level,
// finest first, and each species four layers (VirtualTexel's segments); then for each level one with the mean
// displacement of tips over the species, as a share of their length, in xyz.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "animation/condition_window.h"
#include "animation/eye_windows.h"
#include "animation/virtual_blades.h"
#include "animation/wind.h"

namespace prairie {

/// A virtual blade's species, and its share of the field's blades.
struct SwaySpecies {
  ChainTraits traits;
  float share = 1.0f;
};

/// All that changes; plain data.
struct SwayState {
  glm::dvec2 centre_m{0.0};
  std::vector<ChainMotion> motions;  // by level, species, texel
};

class Sway {
 public:
  /// Blades stand still and upright around `eye_m`.
  Sway(std::vector<SwaySpecies> species, glm::dvec2 eye_m);

  glm::dvec2 centre_m() const { return centre_m_; }

  /// Moves the windows along, the texture with them.
  void follow(glm::dvec2 eye_m);

  /// Blades become as stiff as those of the ground beneath them in these conditions, from where and as they
  /// move now. The windows have to lie around the same eye.
  void stiffen(const ConditionWindow& conditions);

  /// Moves all blades on to `to_s` in the wind of that time.
  void step(const Wind& wind, double to_s, float dt_s);

  int layer_count() const;
  /// The whole texture, of the blades as they are and around where they are.
  std::span<const glm::vec4> image() const { return image_; }

  /// What the shaders read there.
  VirtualTexel at(std::size_t species, glm::dvec2 position_m) const;
  /// Mean displacement of tips, as shares of their length.
  glm::vec3 mean_tip(glm::dvec2 position_m) const;

  SwayState state() const;
  /// Needs a state of as many species, and the wind of its time.
  void restore(const SwayState& state, const Wind& wind, double time_s);

 private:
  struct Level {
    VirtualBlades blades;
    std::vector<glm::vec2> nodes_m_per_s;
    std::vector<glm::vec3> wind_m_per_s;
  };
  void blow(Level& level, const Wind& wind, double time_s);
  void paint();
  void paint_level(std::size_t level);
  std::span<glm::vec4> layer(int index);
  int tip_layer(std::size_t level) const;

  std::vector<SwaySpecies> species_;
  glm::dvec2 centre_m_;
  std::vector<Level> levels_;
  std::vector<glm::vec4> image_;
};

}  // namespace prairie
