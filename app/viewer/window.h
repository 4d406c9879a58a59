// A window with an OpenGL 4.5 core context, and what the person does with keys and mouse in it (GLFW).
#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "agents/driven_cart.h"
#include "app/viewer/fly_camera.h"
#include "app/viewer/key.h"

struct GLFWwindow;

namespace prairie {

class Window {
 public:
  /// Throws NoSuitableOpenGl, also where there is no display. Where the driver offers it, a lost context is
  /// told (render/gl/graphics_reset.h).
  explicit Window(glm::ivec2 size_px);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return handle_; }
  glm::ivec2 size_px() const;  // in the window system's pixels, as the constructor takes them
  glm::ivec2 framebuffer_size_px() const;

  /// Called once per key press, also of keys that nothing stands for.
  std::function<void(Key key)> on_key;

  /// False while it is minimised or hidden, or has no pixels: then there is nothing to draw into.
  bool can_be_seen() const;

  /// Handles what has happened since the last call; returns whether the window is still open. While the
  /// window cannot be seen, it first waits for something to happen, at most half a second.
  bool poll();
  void close();
  void show_frame();

  /// What the held keys, the dragged mouse and its wheel ask for since the last call. Where `mouse_is_taken`,
  /// by what lies over the picture, no new drag begins and the wheel turns nothing.
  Steering steering(bool mouse_is_taken);
  /// What the held arrow keys ask of a cart or a walker.
  CartControls cart_controls() const;

 private:
  struct Library {
    Library();
    ~Library();
  };

  static void count_wheel(GLFWwindow* handle, double aside, double notches);

  Library library_;
  GLFWwindow* handle_ = nullptr;
  bool dragging_ = false;
  glm::dvec2 cursor_px_{0.0};
  double wheel_ = 0.0;  // since the last call of steering()
};

}  // namespace prairie
