// The viewer's text over the picture: times, blades and triangles per tier, position; and a slider for the
// quality (Dear ImGui).
#pragma once

#include <string>

#include "lod/camera.h"
#include "lod/quality.h"
#include "render/renderer.h"

struct GLFWwindow;

namespace prairie {

struct OverlayText {
  double frame_ms = 0.0;
  FrameStatistics statistics;
  Camera camera;
  bool walks = false;
  std::string tier;
  bool tinted = false;
  std::string notice;  // such as the name of the last screenshot
};

class Overlay {
 public:
  /// Needs the window's context to be current, now and until the overlay is gone.
  explicit Overlay(GLFWwindow* window);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Draws into the window's framebuffer; `quality` follows the slider.
  void draw(const OverlayText& text, Quality& quality);

  /// Whether the mouse is on the overlay, or was when its button went down.
  bool wants_mouse() const;
};

}  // namespace prairie
