// Draws a clip of a world that goes on: each frame is drawn while the world goes on to the next one.
#pragma once

#include <optional>

#include "app/outputs/clip.h"
#include "app/scenes/camera_path.h"
#include "app/terminal/global_options.h"
#include "lod/camera.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"
#include "world/scene/scene.h"

namespace prairie {

class World;

/// What a clip shows.
struct ClipView {
  std::optional<CameraPath> path;  // along which the camera goes
  CameraSpec standing;             // where it stands if there is none
  Tier tier = Tier::kAuto;
  int samples = 1;
  std::optional<double> parallel_height_m;  // of a parallel projection
};

class Recording {
 public:
  /// Begins the clip, which outlives it, as does the world. Throws what Clip, HeadlessContext and Renderer
  /// throw.
  Recording(Clip& clip, const ClipView& view, const GlobalOptions& globals, const World& world);

  /// Through which a frame is seen, from 0 on.
  Camera camera(int frame) const;
  /// Adds a frame that shows the world as it is, and does `meanwhile` what Renderer::Meanwhile may.
  void add(int frame, const Renderer::Meanwhile& meanwhile);

 private:
  Clip& clip_;
  ClipView view_;
  const World& world_;
  HeadlessContext context_;
  Renderer renderer_;
  FrameOptions look_;
};

}  // namespace prairie
