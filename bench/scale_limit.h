// The least that a frame's blades could cost on this machine: the same indices over the same vertices, which
// already lie in their buffer, by a program that does nothing but place them (bench/scale_plain.h).
#pragma once

#include <cstdint>
#include <filesystem>

#include "bench/scale_target.h"
#include "lod/camera.h"
#include "lod/planner.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/blade_pass.h"
#include "render/grass/sward_tables.h"
#include "world/world.h"

namespace prairie {

class FrameLimit {
 public:
  FrameLimit(const World& world, const std::filesystem::path& shader_folder);
  /// Plans and grows the frame's blades, as the renderer does.
  void prepare(const Camera& camera, const OffscreenTarget& target);
  /// Draws them once more and waits for the end; in milliseconds.
  double measure_ms(const OffscreenTarget& target);

 private:
  const World* world_;
  GlProgram program_;
  Planner planner_;
  StreamBuffer stream_{std::size_t{1} << 20};
  SwardTables sward_;
  BladePass blades_;
  Camera camera_;
};

}  // namespace prairie
