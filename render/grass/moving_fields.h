// The fields that move grass around the eye and change its look as textures
// (shaders/lib/moving_fields.glsl).
#pragma once

#include "animation/tread_window.h"
#include "render/gl/gl_objects.h"
#include "shaders/shared/layouts.h"
#include "world/motion.h"

namespace prairie {

class MovingFields {
 public:
  /// Makes ready what `show` uploads, so that it has less to do if nothing moves until then. Does without
  /// OpenGL.
  void paint(const Motion& motion, glm::dvec2 eye_m);
  /// Uploads what a frame seen from there needs and tells where it lies.
  void show(const Motion& motion, glm::dvec2 eye_m, ViewParams& view, FieldParams& field);
  /// For all that is drawn or computed from now on.
  void bind() const;

 private:
  void show_conditions(const ConditionWindow& conditions);

  GlTexture sway_;
  int sway_layers_ = 0;
  bool shows_sway_ = false;
  GlTexture treads_;
  TreadWindow window_;
  GlTexture conditions_;
  std::uint64_t conditions_revision_ = 0;  // of what it holds
};

}  // namespace prairie
