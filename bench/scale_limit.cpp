#include "bench/scale_limit.h"

#include <chrono>

#include "bench/scale_plain.h"
#include "render/light/light.h"

namespace prairie {

FrameLimit::FrameLimit(const World& world, const std::filesystem::path& shader_folder)
    : world_(&world),
      program_(make_plain_program()),
      planner_(world.meadow()),
      sward_(world.meadow()),
      blades_(world, shader_folder) {
  sward_.set_light(frame_params(world, FramePlan{}, GroundLook{}, FieldLook{}));
}

void FrameLimit::prepare(const Camera& camera, const OffscreenTarget& target) {
  camera_ = camera;
  const LodSpec& lod = world_->scene().lod;
  const FramePlan plan =
      planner_.plan(camera, {.quality = lod.quality, .blade_distance_m = lod.blade_distance_m});
  stream_.begin_frame();
  const FrameParams frame = frame_params(*world_, plan, GroundLook{}, sward_.field());
  const StreamBuffer::Slice slice = stream_.write(&frame, sizeof(frame));
  glBindBufferRange(GL_UNIFORM_BUFFER, 0, slice.buffer, slice.offset, sizeof(frame));
  sward_.bind();
  blades_.prepare(stream_, plan, sward_.species());
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
