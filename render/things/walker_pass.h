// Draws walkers: one generated figure (render/things/shapes/walker_mesh.h) that each walker's pose bends and
// its colours dress. Instanced, one draw call a level of detail, which follows the figure's height in pixels;
// walkers out of sight are left out. A frame without walkers costs nothing.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "lod/camera.h"
#include "render/gl/draw_state.h"
#include "render/gl/stream_buffer.h"
#include "render/things/shapes/walker_mesh.h"
#include "render/things/walker_look.h"

namespace prairie {

class WalkerPass {
 public:
  /// The figure is closed.
  static constexpr DrawState kState{.culls_backs = true};

  explicit WalkerPass(std::filesystem::path shader_folder);
  ~WalkerPass();
  WalkerPass(const WalkerPass&) = delete;
  WalkerPass& operator=(const WalkerPass&) = delete;

  /// Hands a frame's walkers to the device; `sward_height_m`: of the grass that they stand in. Returns
  /// whether anybody is seen. Throws NoSuitableOpenGl, BadInput where shaders cannot be made.
  bool prepare(StreamBuffer& stream, std::span<const WalkerLook> walkers, const Camera& camera,
               float sward_height_m);
  /// Draws them; the frame's blocks must be bound.
  void draw();
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  struct Device;

  std::filesystem::path shader_folder_;
  std::unique_ptr<Device> device_;  // none until there is somebody to draw
  std::array<std::uint32_t, kWalkerLevels> counts_{};
  StreamBuffer::Slice table_;
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace prairie
