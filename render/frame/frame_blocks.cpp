#include "render/frame/frame_blocks.h"

#include <glm/common.hpp>
#include <limits>

#include "render/gl/uniform_block.h"
#include "render/grass/ground_mesh.h"
#include "render/light/scene_light.h"

namespace prairie {

ViewParams view_params(const FramePlan& plan, const Meadow& meadow) {
  const Camera& camera = plan.camera;
  const glm::dvec3 anchor_m = ground_anchor_m(meadow, camera.eye_m);
  const glm::dvec2 eye_m(camera.eye_m);
  ViewParams view{};
  view.clip_from_eye = camera.clip_from_eye();
  view.towards_eye = glm::vec3(-camera.forward());
  view.parallel = camera.is_orthographic() ? 1.0f : 0.0f;
  view.lod_eye_m = glm::vec3(plan.lod_eye_m - camera.eye_m);
  view.pixel_m = static_cast<float>(camera.pixel_m());
  view.ground_from_eye_m = glm::vec3(anchor_m - camera.eye_m);
  view.anchor_m = glm::vec2(anchor_m);
  view.eye_in_tile_m = glm::vec2(eye_m - meadow.tile_m * glm::floor(eye_m / meadow.tile_m));
  view.lod = plan.lod;
  return view;
}

FieldParams field_params(const Meadow& meadow, const FieldLook& look, glm::dvec2 flat_period_m) {
  FieldParams field{};
  field.mean_albedo = look.mean_albedo;
  field.projected_from_above = static_cast<float>(look.projected_from_above);
  field.soil_color = meadow.soil_color;
  field.density_per_leaf_area = static_cast<float>(look.density_per_leaf_area);
  field.strip_height_m = static_cast<float>(look.height_m);
  field.blade_width_m = static_cast<float>(look.blade_width_m);
  field.tile_m = static_cast<float>(meadow.tile_m);
  field.flat_period_m = glm::vec2(flat_period_m);
  constexpr float kEndless = std::numeric_limits<float>::max();
  field.planted_m = meadow.repeats ? glm::vec4(-kEndless, -kEndless, kEndless, kEndless)
                                   : glm::vec4(0.0f, 0.0f, glm::vec2(meadow.extent_m));
  return field;
}

FrameBlocks plain_blocks(const World& world, const Camera& camera) {
  FramePlan plan;
  plan.camera = camera;
  return {view_params(plan, world.meadow()), scene_light(world.scene().sun),
          field_params(world.meadow(), FieldLook{}, glm::dvec2(1.0))};
}

void bind(StreamBuffer& stream, const FrameBlocks& blocks) {
  bind_uniform_block(stream, layouts::kViewBlock, blocks.view);
  bind_uniform_block(stream, layouts::kLightBlock, blocks.light);
  bind_uniform_block(stream, layouts::kFieldBlock, blocks.field);
}

}  // namespace prairie
