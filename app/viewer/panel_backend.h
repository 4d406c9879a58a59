// Dear ImGui in a window of GLFW's with OpenGL: draws panels over the picture and passes the mouse to them.
#pragma once

#include <vector>

#include "app/viewer/panel.h"

struct GLFWwindow;

namespace prairie {

class PanelBackend {
 public:
  /// Needs the window's context to be current, now and until the backend is gone.
  explicit PanelBackend(GLFWwindow* window);
  ~PanelBackend();
  PanelBackend(const PanelBackend&) = delete;
  PanelBackend& operator=(const PanelBackend&) = delete;

  /// Draws into the window's framebuffer; buttons and sliders follow the mouse.
  void draw(const std::vector<PanelWindow>& windows, PanelInput& input);

  /// Whether the mouse is on a panel, or was when its button went down.
  bool wants_mouse() const;
};

}  // namespace prairie
