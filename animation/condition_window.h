// What has come over the grass around the eye (animation/condition.h) as the texture that all tiers read:
// windows of rising texel size (animation/eye_windows.h), one layer each: the factors on colour in rgb and on
// stiffness in alpha.
//
// A texel is the mean of the nodes on it, half a texel apart, those on its border shared with its neighbours.
// Windows are evaluated only where a condition reaches them, and anew only when what covers them changes or
// they move.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "animation/condition.h"
#include "animation/eye_windows.h"

namespace prairie {

class ConditionWindow {
 public:
  /// Untouched grass around an eye.
  explicit ConditionWindow(glm::dvec2 eye_m);

  /// Brings the windows to an eye and to the conditions of a time. Whether any texel changed or moved.
  bool show(std::span<const Condition> conditions, glm::dvec2 eye_m, double time_s);

  glm::dvec2 centre_m() const { return centre_m_; }
  /// Not faded into the coarser window; by index of the torus.
  std::span<const GrassCondition> texels(std::size_t level) const { return levels_[level].texels; }

  /// kWindowLevels layers.
  std::span<const glm::vec4> image() const { return image_; }
  /// Counts the images: where it is the same, so is the image.
  std::uint64_t revision() const { return revision_; }
  /// What the shaders read there.
  GrassCondition at(glm::dvec2 position_m) const;

 private:
  struct Level {
    glm::ivec2 corner;
    std::vector<PresentCondition> covered_by;
    std::vector<GrassCondition> texels;
  };
  static void fill(std::size_t index, Level& level);
  void paint();

  glm::dvec2 centre_m_;
  std::array<Level, kWindowLevels> levels_;
  std::vector<glm::vec4> image_;
  std::uint64_t revision_ = 1;
};

}  // namespace prairie
