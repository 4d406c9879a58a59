#include "bench/walking_eye.h"

#include <chrono>
#include <cstddef>

#include "world/motion.h"

namespace prairie {

WalkingEye::WalkingEye(const ScaleGround& ground, const ScaleVariant& variant, const BenchOptions& options)
    : world_(scale_world(ground, variant)), renderer_(world_, options.shader_folder) {}

void WalkingEye::step(int frame, const OffscreenTarget& target) {
  const Camera seen = camera(frame);
  const bool moves = world_.scene().wind || !world_.walkers().empty();
  const auto go_on = [&] {
    world_.motion().watch(glm::dvec2(seen.eye_m));
    world_.step(kWalkFrameS);
  };
  const auto start = std::chrono::steady_clock::now();
  statistics_ = renderer_.draw({seen, {}, target.framebuffer()},
                               moves ? Renderer::Meanwhile(go_on) : Renderer::Meanwhile());
  glFinish();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  if (frame < 0) return;
  frame_ms_.push_back(elapsed.count());
  plan_ms_.push_back(statistics_.plan_ms);
}

void WalkingEye::begin_again() {
  frame_ms_.clear();
  plan_ms_.clear();
}

}  // namespace prairie
