// Blades that move by themselves (animation/touched_blades.h) where shaders find them
// (shaders/lib/touched_blades.glsl).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "animation/touched_blades.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/gl/texel_view.h"

namespace prairie {

class TouchedChains {
 public:
  TouchedChains();

  /// Once a frame, before its runs.
  void set(StreamBuffer& stream, const TouchedBlades& blades);
  /// Whether blades of a cell (PlantedCell::key) move by themselves.
  bool holds(glm::uvec2 key) const { return first_slots_.contains(packed(key)); }

  /// Shows a run's cells where their blades are.
  void show(StreamBuffer& stream, std::span<const DrawnCell> run);

 private:
  static std::uint64_t packed(glm::uvec2 key) { return (std::uint64_t{key.x} << 32) | key.y; }

  std::unordered_map<std::uint64_t, std::uint32_t> first_slots_;
  std::vector<std::uint32_t> slots_;
  std::vector<float> chains_;
  std::vector<std::uint32_t> run_cells_;
  TexelView cell_view_{GL_R32UI, "touched cells"};
  TexelView slot_view_{GL_R32UI, "touched slots"};
  TexelView chain_view_{GL_RGBA32F, "touched chains"};
};

}  // namespace prairie
