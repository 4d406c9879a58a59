#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_folder.h"
#include "bench/scale_scene.h"
#include "pictures/flip.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr int kReferenceSamples = 4;  // of 4 each

struct MeanLook {
  glm::dvec3 color{0.0};
  double cover = 0.0;
};

/// Over the pixels that show ground.
MeanLook mean_look(const Picture& picture, const std::vector<bool>& is_ground) {
  MeanLook sum;
  double pixels = 0.0;
  for (std::size_t n = 0; n < is_ground.size(); ++n) {
    if (!is_ground[n]) continue;
    pixels += 1.0;
    for (int channel = 0; channel < 3; ++channel)
      sum.color[channel] +=
          static_cast<double>(picture.linear_rgb[3 * n + static_cast<std::size_t>(channel)]);
    sum.cover += static_cast<double>(picture.cover[n]);
  }
  return {sum.color / pixels, sum.cover / pixels};
}

}  // namespace

std::vector<Measurement> bench_scale_picture(const BenchOptions& options) {
  const BenchFolder folder;
  const ScaleGround ground = scale_ground(folder.path());
  const World world = scale_world(ground, {});
  const HeadlessContext context(options.device);
  Renderer renderer(world, options.shader_folder);
  const Camera camera = walk_camera(world, kWalkFrames - 1);
  const Picture frame = renderer.render(camera, {}, 1);
  const Picture flat = renderer.render(camera, {.tier = Tier::kFlat}, 1);
  const Picture reference = renderer.render(camera, {.tier = Tier::kSpline, .msaa = true}, kReferenceSamples);
  std::vector<bool> is_ground;
  for (std::size_t n = 0; n < frame.cover.size(); ++n) {
    is_ground.push_back(std::max({frame.cover[n], flat.cover[n], reference.cover[n]}) > 0.0f);
  }
  const MeanLook look = mean_look(frame, is_ground);
  const MeanLook expected = mean_look(reference, is_ground);
  double color_error = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    color_error = std::max(color_error, std::abs(look.color[channel] / expected.color[channel] - 1.0));
  }
  const double flip =
      mean_flip({reference.width, reference.height, reference.srgb}, {frame.width, frame.height, frame.srgb});
  return {{"picture.scale_color_error", color_error},
          {"picture.scale_cover_error", std::abs(look.cover - expected.cover)},
          {"picture.scale_flip", flip}};
}

}  // namespace prairie
