// The viewer's text over the picture: frame time, blades, position (Dear ImGui).
#pragma once

#include <cstdint>
#include <string>

#include "lod/camera.h"

struct GLFWwindow;

namespace prairie {

struct OverlayText {
  double frame_ms = 0.0;
  std::uint64_t blades_drawn = 0;
  std::uint64_t triangles = 0;
  Camera camera;
  bool walks = false;
  std::string tier;
  std::string notice;  // such as the name of the last screenshot
};

class Overlay {
 public:
  /// Needs the window's context to be current, now and until the overlay is gone.
  explicit Overlay(GLFWwindow* window);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Draws into the window's framebuffer.
  void draw(const OverlayText& text);
};

}  // namespace prairie
