#include "bench/scale_limit.h"

#include <chrono>

#include "bench/scale_plain.h"
#include "render/frame/frame_blocks.h"
#include "render/light/scene_light.h"

namespace prairie {

FrameLimit::FrameLimit(const World& world, const std::filesystem::path& shader_folder)
    : world_(&world),
      program_(make_plain_program()),
      planner_(world.meadow()),
      sward_(world.meadow(), scene_light(world.scene().sun)),
      blades_(world.meadow(), shader_folder) {}

void FrameLimit::prepare(const Camera& camera, const OffscreenTarget& target) {
  camera_ = camera;
  const LodSpec& lod = world_->scene().lod;
  const FramePlan plan =
      planner_.plan(camera, {.quality = lod.quality, .blade_distance_m = lod.blade_distance_m});
  stream_.begin_frame();
  const Meadow& meadow = world_->meadow();
  bind(stream_, {view_params(plan, meadow), scene_light(world_->scene().sun),
                 field_params(meadow, sward_.field(), glm::dvec2(1.0))});
  sward_.bind();
  blades_.prepare(stream_, {plan.cells, plan.groups, plan.tables}, sward_.species());
  measure_ms(target);  // the first drawing grows the vertices
}

double FrameLimit::measure_ms(const OffscreenTarget& target) {
  const auto start = std::chrono::steady_clock::now();
  begin_plain(program_.get(), target.framebuffer(), camera_);
  blades_.draw(stream_, program_.get());
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace prairie
