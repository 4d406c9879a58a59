// Trodden grass around the eye as a texture: windows of rising node spacing, tori as those of animation/sway.h and as wide,
// of bytes. A coarser one holds what lies beyond the finer. Only what has been trodden costs something.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "animation/treading.h"

namespace prairie {

/// Lean east, lean north and tilt as shares of kTreadMostRad, and wear; signed bytes, 127 stands for 1.
using TreadTexel = std::array<std::int8_t, 4>;

class TreadWindow {
 public:
  TreadWindow();

  /// Paints what `treading` holds around `eye_m` at its time.
  void paint(const Treading& treading, glm::dvec2 eye_m);

  glm::dvec2 centre_m() const { return centre_m_; }
  bool is_empty() const { return painted_.empty(); }
  /// kTreadLevels layers of kTreadSide², rows from the torus' first.
  std::span<const TreadTexel> image() const { return image_; }

 private:
  struct Painted {
    std::uint32_t index;  // in the image
    TreadTexel texel;
  };
  void paint_page(const Treading& treading, PageIndex page, int level, std::vector<Painted>& painted) const;

  glm::dvec2 centre_m_{0.0};
  std::vector<TreadTexel> image_;
  std::vector<std::uint32_t> painted_;  // indices of texels that are not at rest
};

}  // namespace prairie
