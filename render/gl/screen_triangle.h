// A fragment shader for each pixel of a target: one triangle that covers all of it
// (shaders/pass/screen.vert).
#pragma once

#include "render/gl/gl_objects.h"

namespace prairie {

class ScreenTriangle {
 public:
  /// Runs the program in use for every pixel of the viewport.
  void draw() const {
    glBindVertexArray(no_vertices_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  GlVertexArray no_vertices_ = make_vertex_array("screen triangle");
};

}  // namespace prairie
