#include "render/grass/moving_fields.h"

#include <cmath>

namespace prairie {
namespace {

GlTexture make_torus(GLenum format, int side, int layers, const char* label) {
  GlTexture texture = make_texture(GL_TEXTURE_2D_ARRAY, label);
  glTextureStorage3D(texture.get(), 1, format, side, side, layers);
  set_sampling(texture, {.minified = GL_LINEAR, .magnified = GL_LINEAR, .wrap = GL_REPEAT});
  return texture;
}

double coarsest_period_m() {
  return static_cast<double>(layouts::kSwaySide * layouts::kSwayFinestM) *
         std::pow(static_cast<double>(layouts::kSwayCoarsening), layouts::kSwayLevels - 1);
}

}  // namespace

void MovingFields::paint(const Motion& motion, glm::dvec2 eye_m) {
  if (motion.treading().bytes() > 0 || !window_.is_empty())
    window_.paint(motion.treading(), motion.eye_m().value_or(eye_m));
}

void MovingFields::show(const Motion& motion, glm::dvec2 eye_m, ViewParams& view, FieldParams& field) {
  const std::optional<Sway>& sway = motion.sway();
  const ConditionWindow* conditions = motion.conditions();
  // Around the eye that watches lie blades that sway and conditions, too.
  const glm::dvec2 centre_m = motion.eye_m().value_or(eye_m);
  const double period_m = coarsest_period_m();
  view.window_from_eye_m = glm::vec2(centre_m - eye_m);
  field.window_m = glm::vec2(centre_m - period_m * glm::floor(centre_m / period_m));
  const double periods = motion.time_s() / static_cast<double>(layouts::kSwayPeriodS);
  field.sway_time = static_cast<float>(periods - std::floor(periods));

  if (conditions != nullptr) show_conditions(*conditions);
  const bool has_treads = motion.treading().bytes() > 0;
  if (!sway && !has_treads) return;
  // In still air one species of texels at rest stands for all.
  const int layers = sway ? sway->layer_count() : layouts::kSwayLevels * 5;
  if (layers != sway_layers_ || shows_sway_ != sway.has_value()) {
    sway_ = make_torus(GL_RGBA32F, layouts::kSwaySide, layers, "sway");
    sway_layers_ = layers;
    shows_sway_ = sway.has_value();
    const float rest[4] = {};
    glClearTexImage(sway_.get(), 0, GL_RGBA, GL_FLOAT, rest);
  }
  if (sway) {
    glTextureSubImage3D(sway_.get(), 0, 0, 0, 0, layouts::kSwaySide, layouts::kSwaySide, layers, GL_RGBA,
                        GL_FLOAT, sway->image().data());
  }
  if (has_treads || !window_.is_empty()) {
    if (treads_.get() == 0) {
      treads_ = make_torus(GL_RGBA8_SNORM, layouts::kTreadSide, layouts::kTreadLevels, "treads");
      const std::int8_t rest[4] = {};
      glClearTexImage(treads_.get(), 0, GL_RGBA, GL_BYTE, rest);
    }
    paint(motion, eye_m);
    for (const TreadWindow::Rows& rows : window_.take_changed()) {
      const auto first =
          static_cast<std::size_t>(rows.layer * layouts::kTreadSide + rows.first) * layouts::kTreadSide;
      glTextureSubImage3D(treads_.get(), 0, 0, rows.first, rows.layer, layouts::kTreadSide, rows.count, 1,
                          GL_RGBA, GL_BYTE, window_.image().subspan(first).data());
    }
  }
}

void MovingFields::show_conditions(const ConditionWindow& conditions) {
  if (conditions.revision() == conditions_revision_) return;
  conditions_revision_ = conditions.revision();
  if (conditions_.get() == 0)
    conditions_ = make_torus(GL_RGBA32F, layouts::kSwaySide, layouts::kSwayLevels, "conditions");
  glTextureSubImage3D(conditions_.get(), 0, 0, 0, 0, layouts::kSwaySide, layouts::kSwaySide,
                      layouts::kSwayLevels, GL_RGBA, GL_FLOAT, conditions.image().data());
}

void MovingFields::bind() const {
  glBindTextureUnit(layouts::kSwayUnit, sway_.get());
  glBindTextureUnit(layouts::kTreadUnit, treads_.get());
  glBindTextureUnit(layouts::kConditionUnit, conditions_.get());
}

}  // namespace prairie
