// A window with an OpenGL 4.5 core context, and what the person does with keys and mouse in it (GLFW).
#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "app/fly_camera.h"

struct GLFWwindow;

namespace prairie {

class Window {
 public:
  /// Throws NoSuitableOpenGl, also where there is no display.
  explicit Window(glm::ivec2 size_px);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return handle_; }
  glm::ivec2 framebuffer_size_px() const;

  /// Called once per key press with GLFW's key code.
  std::function<void(int key)> on_key;

  /// Handles what has happened since the last call; returns whether the window is still open.
  bool poll();
  void close();
  void show_frame();

  /// What the held keys and the dragged mouse ask for since the last call.
  Steering steering();

 private:
  struct Library {
    Library();
    ~Library();
  };

  Library library_;
  GLFWwindow* handle_ = nullptr;
  bool dragging_ = false;
  glm::dvec2 cursor_px_{0.0};
};

}  // namespace prairie
