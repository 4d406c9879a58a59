// Draws fields over the picture (render/overlays/field_overlay.h). What grass and solids hide of them shows
// faintly through: in a sward little of the ground can be seen. The shaders are compiled when an overlay is
// first asked for.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>

#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/overlays/field_overlay.h"

namespace prairie {

class FieldOverlayPass {
 public:
  static constexpr DrawState kState{
      .depth_test = DepthTest::kCloserOrEqual, .writes_depth = false, .blends = true};

  explicit FieldOverlayPass(std::filesystem::path shader_folder);

  /// Hands what a frame shows to the device; whether there is anything. Throws NoSuitableOpenGl, BadInput
  /// where shaders cannot be made.
  bool prepare(StreamBuffer& stream, const World& world, glm::dvec3 eye_m, FieldOverlay overlay);
  /// Blends it into the bound target, depth-tested against it; the frame's blocks must be bound. Leaves the
  /// target's alpha and depth as they are.
  void draw();

 private:
  static constexpr DrawState kHiddenState{
      .depth_test = DepthTest::kFarther, .writes_depth = false, .blends = true};

  std::filesystem::path shader_folder_;
  std::array<GlProgram, 4> programs_;  // by FieldOverlay
  GlVertexArray no_vertices_;
  FieldOverlay shown_ = FieldOverlay::kNone;
  std::size_t count_ = 0;
  StreamBuffer::Slice table_;
};

}  // namespace prairie
