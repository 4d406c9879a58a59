// Trodden grass around the eye as a texture: windows of rising node spacing, tori as those of
// animation/eye_windows.h and as wide, of bytes. A coarser one holds what lies beyond the finer. Only what
// has been trodden costs something.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "animation/treading.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// Lean east, lean north and tilt as shares of kTreadMostRad, and wear; signed bytes, 127 stands for 1.
using TreadTexel = std::array<std::int8_t, 4>;

class TreadWindow {
 public:
  TreadWindow();

  /// Paints what `treading`, the same each time, holds around `eye_m` at its time; nothing where that is
  /// painted already.
  void paint(const Treading& treading, glm::dvec2 eye_m);

  glm::dvec2 centre_m() const { return centre_m_; }
  bool is_empty() const { return painted_.empty(); }
  /// kTreadLevels layers of kTreadSide², rows from the torus' first.
  std::span<const TreadTexel> image() const { return image_; }

  /// Rows of a layer.
  struct Rows {
    int layer, first, count;
  };
  /// Outside these the image is what it was when this was last asked; at first, empty.
  std::vector<Rows> take_changed();

 private:
  /// Texels of the endless lattice that the torus holds a part of.
  struct Block {
    int level = 0;
    int first_row = 0, end_row = 0, first_column = 0, end_column = 0;
  };
  static std::size_t index_of(int level, int row, int column);
  void mark(const Block& block);
  std::vector<PageIndex> pages_around(const Treading& treading) const;
  /// Paints the texels whose middles lie in the page.
  Block paint_page(const Treading& treading, PageIndex page, int level);

  glm::dvec2 centre_m_{0.0};
  std::uint64_t revision_ = 0;  // of what is painted; 0: nothing yet
  std::vector<TreadTexel> image_;
  std::vector<Block> painted_;  // the rest is at rest
  std::array<std::array<bool, layouts::kTreadSide>, layouts::kTreadLevels> is_changed_{};  // rows
};

}  // namespace prairie
