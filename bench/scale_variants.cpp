// What other fields cost on the same walk, frame by frame in turn: sparser, denser, and a hundred times as
// large; and with the wind on.
#include <vector>

#include "bench/benches.h"
#include "bench/scale_folder.h"
#include "bench/timing.h"
#include "bench/walking_eye.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr int kVariantFrames = 30;

}  // namespace

std::vector<Measurement> bench_scale_variants(const BenchOptions& options) {
  const BenchFolder folder;
  const ScaleGround ground = scale_ground(folder.path());
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  WalkingEye plain(ground, {}, options);
  WalkingEye sparse(ground, {.density_factor = 0.1}, options);
  WalkingEye dense(ground, {.density_factor = 10.0}, options);
  WalkingEye repeated(ground, {.repeats = true}, options);
  WalkingEye windy(ground, {.windy = true}, options);
  for (int frame = -kWarmUpFrames; frame < kVariantFrames; ++frame) {
    for (WalkingEye* walker : {&plain, &sparse, &dense, &repeated, &windy}) walker->step(frame, target);
  }
  const double sparse_ms = median(sparse.frame_ms());
  const double dense_ms = median(dense.frame_ms());
  return {{"scale.density_100_ms", sparse_ms},
          {"scale.density_10000_ms", dense_ms},
          {"scale.density_ratio", dense_ms / sparse_ms},
          {"scale.wind_ratio", median(windy.frame_ms()) / median(plain.frame_ms())},
          {"scale.repeat10_ratio", median(repeated.frame_ms()) / median(plain.frame_ms())}};
}

}  // namespace prairie
