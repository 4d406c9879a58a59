// The measure of a machine, by which frame times of different machines and of busy hours compare: 60 000
// plain blades of seven triangles, standing ready in a vertex buffer, as densely before the eye as a meadow's
// near field.
#pragma once

#include "bench/scale_target.h"
#include "lod/camera.h"
#include "render/gl/gl_objects.h"

namespace prairie {

class BladeProbe {
 public:
  BladeProbe();
  /// Draws them once and waits for the end; in milliseconds.
  double measure_ms(const OffscreenTarget& target) const;

 private:
  GlProgram program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_{"probe vertices"};
  GlBuffer indices_{"probe indices"};
  Camera camera_;
};

}  // namespace prairie
