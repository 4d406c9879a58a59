// What goes with the OpenGL context: the window, the renderer and what draws the panels. After a reset of the
// graphics device, another stage is raised in its place.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "app/viewer/panel.h"
#include "app/viewer/panel_backend.h"
#include "app/viewer/window.h"
#include "lod/camera.h"
#include "render/frame/renderer.h"

namespace prairie {

class World;

class Stage {
 public:
  /// Throws NoSuitableOpenGl, BadInput.
  Stage(const World& world, glm::ivec2 size_px);

  Window& window() { return window_; }
  bool panels_want_mouse() const { return panels_.wants_mouse(); }

  /// Draws the picture into the window; `meanwhile` as the renderer takes it. Throws LostContext, OverBudget.
  FrameStatistics draw(const Camera& camera, const FrameOptions& options,
                       const std::function<void()>& meanwhile);
  /// Over the picture.
  void draw_panels(const std::vector<PanelWindow>& windows, PanelInput& input);
  void show_frame() { window_.show_frame(); }

  /// The picture without panels, for a file. Throws LostContext, OverBudget.
  Picture picture(const Camera& camera, const FrameOptions& options);

 private:
  Window window_;
  Renderer renderer_;
  PanelBackend panels_;
};

}  // namespace prairie
