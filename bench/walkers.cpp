// Walkers: a step of a crowd, and what two hundred of them add to a frame of the walk of bench `scale`.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_folder.h"
#include "bench/timing.h"
#include "bench/walking_eye.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr int kWarmUpSteps = 60;
constexpr int kSteps = 150;
constexpr double kStepS = 1.0 / 30.0;
constexpr double kPerM2 = 0.04;
constexpr int kFrames = 30;

/// A meadow with so many walkers, in which an obstacle stands for every fifty of them.
World crowded(int walkers) {
  const double radius_m = std::sqrt(walkers / kPerM2 / 3.141592653589793), side_m = 2.0 * radius_m + 20.0;
  std::string text = fmt::format(R"(version = 1
[ground]
size_m = [{0}, {0}]
[[species]]
name = "grass"
density = 1000
height_m = 0.4
[[wall]]
outline_m = [[0, 0], [{0}, 0], [{0}, {0}], [0, {0}]]
[[walkers]]
name = "people"
count = {1}
position_m = [{2}, {2}]
radius_m = {3}
)",
                                 side_m, walkers, 0.5 * side_m, radius_m);
  for (int n = 0; n < walkers / 50; ++n) {
    const glm::dvec2 share(std::fmod(0.7548776662466927 * (n + 1), 1.0),
                           std::fmod(0.5698402909980532 * (n + 1), 1.0));
    constexpr const char* kKinds[] = {"trunk", "box", "rock"};
    text += fmt::format("[[obstacle]]\nkind = \"{}\"\nposition_m = [{}, {}]\n", kKinds[n % 3],
                        5.0 + (side_m - 10.0) * share.x, 5.0 + (side_m - 10.0) * share.y);
  }
  return World(parse_scene(text, ".", {}), {});
}

double step_ms(int walkers) {
  World world = crowded(walkers);
  for (int n = 0; n < kWarmUpSteps; ++n) world.step(kStepS);
  return median_ms(kSteps, [&](int) { return elapsed_ms([&] { world.step(kStepS); }); });
}

}  // namespace

std::vector<Measurement> bench_walker_steps(const BenchOptions&) {
  const double ms_1k = step_ms(1000), ms_10k = step_ms(10'000);
  return {{"walkers.step_ms_1k", ms_1k},
          {"walkers.step_ms_10k", ms_10k},
          {"walkers.step_growth", ms_10k / ms_1k}};
}

std::vector<Measurement> bench_walker_frames(const BenchOptions& options) {
  const BenchFolder folder;
  const ScaleGround ground = scale_ground(folder.path());
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  WalkingEye empty(ground, {}, options), peopled(ground, {.walkers = 200}, options);
  for (int frame = -kWarmUpFrames; frame < kFrames; ++frame) {
    for (WalkingEye* eye : {&empty, &peopled}) eye->step(frame, target);
  }
  const double empty_ms = median(empty.frame_ms()), peopled_ms = median(peopled.frame_ms());
  return {{"walkers.frame_ms_200", peopled_ms}, {"walkers.frame_ratio_200", peopled_ms / empty_ms}};
}

}  // namespace prairie
