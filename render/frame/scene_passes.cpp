#include "render/frame/scene_passes.h"

#include "render/gl/uniform_block.h"
#include "render/grass/strip_painter.h"
#include "render/light/noise_texture.h"
#include "render/light/scene_light.h"
#include "render/things/drawn_walkers.h"
#include "render/things/mover_look.h"
#include "world/motion.h"

namespace prairie {
namespace {

void bind_scene(StreamBuffer& stream, const LightParams& light, const FieldParams& field) {
  bind_uniform_block(stream, layouts::kLightBlock, light);
  bind_uniform_block(stream, layouts::kFieldBlock, field);
}

StripTexture painted_strips(const ScenePasses& scene, BladePass& blades, const Meadow& meadow,
                            const std::filesystem::path& shader_folder, StreamBuffer& stream) {
  bind_scene(stream, scene.light, scene.field);
  scene.sward.bind();
  return paint_strips(stream, blades, scene.sward.species(), meadow.tile_m, meadow.seed, shader_folder);
}

SkyPass lit_sky(const ScenePasses& scene, const std::filesystem::path& shader_folder, StreamBuffer& stream) {
  bind_scene(stream, scene.light, scene.field);
  glBindTextureUnit(layouts::kNoiseUnit, scene.noise.get());
  return SkyPass(shader_folder);
}

}  // namespace

ScenePasses::ScenePasses(const World& world, const std::filesystem::path& shader_folder, StreamBuffer& stream)
    : light(scene_light(world.scene().sun)),
      noise(make_noise_texture()),
      sward(world.meadow(), light),
      ground(world.meadow(), shader_folder, sward.field().blade_area_from_above_m2),
      field(field_params(world.meadow(), sward.field(), ground.flat_period_m())),
      blades(world.meadow(), shader_folder),
      strips(shader_folder, painted_strips(*this, blades, world.meadow(), shader_folder, stream)),
      obstacles(shader_folder),
      solids(shader_folder),
      walkers(shader_folder),
      sky(lit_sky(*this, shader_folder, stream)),
      field_overlay(shader_folder),
      lines(shader_folder) {
  obstacles.set(world.standing(), world.meadow().ground);
}

void ScenePasses::bind_shared() const {
  sward.bind();
  moving_fields.bind();
  glBindTextureUnit(layouts::kNoiseUnit, noise.get());
}

std::vector<Pass> passes_of(ScenePasses& scene) {
  return {
      {.name = "blades",
       .state = BladePass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.blades.prepare(in.stream, {in.plan.cells, in.plan.groups, in.plan.tables},
                                         scene.sward.species(), in.variant, &in.world.motion().touched());
           },
       .draw = [&](const ViewInputs& in) { scene.blades.draw(in.stream); },
       .triangles = [&] { return scene.blades.spline_triangles() + scene.blades.hermite_triangles(); }},
      {.name = "strips",
       .state = StripPass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.strips.prepare(in.stream, in.plan, scene.sward.species(), in.variant);
           },
       .draw = [&](const ViewInputs&) { scene.strips.draw(); },
       .triangles = [&] { return scene.strips.triangles(); }},
      {.name = "obstacles",
       .state = ObstaclePass::kState,
       .prepare = [&](const ViewInputs& in) { return scene.obstacles.prepare(in.plan.camera); },
       .draw = [&](const ViewInputs&) { scene.obstacles.draw(); },
       .triangles = [&] { return scene.obstacles.triangles_drawn(); }},
      {.name = "solids",
       .state = SolidPass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.solids.prepare(in.stream, drawn_movers(in.world), in.plan.camera);
           },
       .draw = [&](const ViewInputs&) { scene.solids.draw(); },
       .triangles = [&] { return scene.solids.triangles_drawn(); }},
      {.name = "walkers",
       .state = WalkerPass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.walkers.prepare(in.stream, drawn_walkers(in.world, in.plan.camera), in.plan.camera,
                                          in.sward_height_m);
           },
       .draw = [&](const ViewInputs&) { scene.walkers.draw(); },
       .triangles = [&] { return scene.walkers.triangles_drawn(); }},
      {.name = "ground",
       .state = GroundPass::kState,
       .prepare = [](const ViewInputs& in) { return !in.plan.ground.empty(); },
       .draw = [&](const ViewInputs& in) { scene.ground.draw(in.plan, in.variant); },
       .triangles = [&] { return scene.ground.triangles_drawn(); }},
      {.name = "sky",
       .state = SkyPass::kState,
       .prepare = [](const ViewInputs&) { return true; },
       .draw = [&](const ViewInputs& in) { scene.sky.draw(in.plan.camera); }},
      {.name = "fields",
       .state = FieldOverlayPass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.field_overlay.prepare(in.stream, in.world, in.plan.camera.eye_m,
                                                in.options.field_overlay);
           },
       .draw = [&](const ViewInputs&) { scene.field_overlay.draw(); }},
      {.name = "lines",
       .state = LinePass::kState,
       .prepare =
           [&](const ViewInputs& in) {
             return scene.lines.prepare(in.stream, in.options.lines, in.plan.camera);
           },
       .draw = [&](const ViewInputs&) { scene.lines.draw(); }},
  };
}

}  // namespace prairie
