// The viewer's text over the picture: times, blades and triangles per tier, position; sliders for the quality
// and the wind, and buttons that stand for keys (Dear ImGui).
#pragma once

#include <cstddef>
#include <string>

#include "app/viewer/wind_controls.h"
#include "lod/camera.h"
#include "lod/quality.h"
#include "render/frame/renderer.h"

struct GLFWwindow;

namespace prairie {

struct OverlayText {
  double frame_ms = 0.0;
  FrameStatistics statistics;
  Camera camera;
  std::string movement;  // of the camera, such as "flying"
  std::string tier;
  bool tinted = false;
  double time_s = 0.0;
  bool paused = false;
  std::size_t touched_blades = 0;  // that move by themselves
  double steps_ms = 0.0;           // of the last frame
  bool has_cart = false;
  FieldOverlay field = FieldOverlay::kNone;
  std::string walkers;  // lines about them; none where nobody walks
  std::string notice;   // such as the name of the last screenshot
};

struct OverlaySliders {
  Quality quality = Quality::kMedium;
  WindControls wind;
};

class Overlay {
 public:
  /// Needs the window's context to be current, now and until the overlay is gone.
  explicit Overlay(GLFWwindow* window);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Draws into the window's framebuffer; `sliders` follow the mouse. Returns the key (GLFW's code) whose
  /// button was pressed, or 0.
  int draw(const OverlayText& text, OverlaySliders& sliders);

  /// Whether the mouse is on the overlay, or was when its button went down.
  bool wants_mouse() const;
};

}  // namespace prairie
