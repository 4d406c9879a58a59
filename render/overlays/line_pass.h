// Draws straight lines over the picture, of the same width in pixels at any distance. What grass and solids
// hide of them shows faintly through, as in render/overlays/field_overlay_pass.h. The shaders are compiled
// when there is first a line to draw.
//
// Each line is a strip of two triangles, all of them in one draw without instances, which costs a software
// renderer the least; lines that are out of sight never reach the device.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "lod/camera.h"
#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/overlays/line_segment.h"

namespace prairie {

class LinePass {
 public:
  static constexpr DrawState kState{
      .depth_test = DepthTest::kCloserOrEqual, .writes_depth = false, .blends = true};

  explicit LinePass(std::filesystem::path shader_folder);

  /// Hands a frame's lines to the device; whether any are seen. Throws NoSuitableOpenGl, BadInput where
  /// shaders cannot be made.
  bool prepare(StreamBuffer& stream, std::span<const LineSegment> lines, const Camera& camera);
  /// Blends them into the bound target, depth-tested against it; the frame's blocks must be bound. Leaves the
  /// target's alpha and depth as they are.
  void draw();

 private:
  static constexpr DrawState kHiddenState{
      .depth_test = DepthTest::kFarther, .writes_depth = false, .blends = true};

  std::filesystem::path shader_folder_;
  GlProgram program_;
  GlVertexArray no_vertices_;
  std::size_t count_ = 0;
  glm::vec2 size_px_{0.0f};
  StreamBuffer::Slice table_;
};

}  // namespace prairie
