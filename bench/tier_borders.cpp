// Whether borders between tiers can be seen: the camera stands still while the eye for which tiers are chosen
// walks away in steps of 5 cm, so that a stretch of ground goes through the whole of a band.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "bench/benches.h"
#include "bench/tier_scene.h"
#include "pictures/picture_metrics.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr double kStepM = 0.05;
constexpr int kBlockPx = 20;

struct Border {
  const char* key;
  double eye_height_m;
  double near_m, far_m;  // of the ground that is looked at
  double from_m, to_m;   // how far the tiers' eye stands behind the camera
  glm::dvec2 extent_m;
};

// Of quality medium; each stretch of ground lies before the band in the first frame and behind it in the
// last, with all the tiles (of 4 m) or quarters of cells (1 m) that it touches.
constexpr Border kBorders[] = {{"spline", 1.7, 3.4, 4.4, -1.5, 1.5, {16.0, 30.0}},
                               {"strip", 1.7, 12.0, 17.0, -7.0, 7.0, {32.0, 60.0}},
                               {"flat", 12.0, 96.0, 128.0, -34.0, 34.0, {48.0, 200.0}}};

// From the horizon down to a little before the stretch of ground: the tiers' eye does not walk through the
// picture.
Camera camera_of(const Border& border, const TierScene& scene) {
  constexpr int kWidthPx = 200;
  const Camera wide = tier_camera(scene, border.eye_height_m, {kWidthPx, kWidthPx});
  const int below_horizon = row_of_ground(wide, border.eye_height_m, 0.8 * border.near_m) - kWidthPx / 2;
  return tier_camera(scene, border.eye_height_m, {kWidthPx, 2 * below_horizon});
}

std::vector<Measurement> measure(const Border& border, const BenchOptions& options) {
  const HeadlessContext context(options.device);
  // One scene of each species, of middle density, with the sun behind.
  StepEvenness worst;
  worst.ratio = 0.0;
  double cover_spread = 0.0;
  for (const TierScene& tier_scene : tier_scenes(border.extent_m)) {
    if (!tier_scene.is_middle) continue;
    const World world(tier_scene.scene, {});
    Renderer renderer(world, options.shader_folder);
    const Camera camera = camera_of(border, tier_scene);
    const int top = row_of_ground(camera, border.eye_height_m, border.far_m);
    const int bottom = std::min(row_of_ground(camera, border.eye_height_m, border.near_m), camera.size_px.y);
    std::vector<std::vector<double>> frames;
    double least_cover = 1.0, most_cover = 0.0;
    for (double behind_m = border.from_m; behind_m <= border.to_m; behind_m += kStepM) {
      FrameOptions frame;
      frame.msaa = true;  // that thin blades do not flicker between pixels
      frame.lod_eye_m = camera.eye_m - glm::dvec3(0.0, behind_m, 0.0);
      const Picture picture = renderer.render(camera, frame, 1);
      frames.push_back(block_luminances({picture.width, picture.height, picture.linear_rgb}, kBlockPx));
      const double cover = mean_cover(picture, {0, top, picture.width, bottom - top});
      least_cover = std::min(least_cover, cover);
      most_cover = std::max(most_cover, cover);
    }
    const StepEvenness steps = step_evenness(frames);
    if (options.details) {
      const auto blocks_wide = static_cast<std::size_t>(camera.size_px.x / kBlockPx);
      *options.details << fmt::format(
          "{:<30} {:<8} step {:.4f} (to {:.2f} m, block {}, {}) median {:.4f} ratio {:.2f} cover "
          "{:.3f}..{:.3f}\n",
          tier_scene.name, border.key, steps.largest,
          border.from_m + kStepM * static_cast<double>(steps.largest_frame),
          steps.largest_block % blocks_wide, steps.largest_block / blocks_wide, steps.median, steps.ratio,
          least_cover, most_cover);
    }
    worst.largest = std::max(worst.largest, steps.largest);
    worst.ratio = std::max(worst.ratio, steps.ratio);
    cover_spread = std::max(cover_spread, most_cover - least_cover);
  }
  return {{fmt::format("picture.border_{}_step", border.key), worst.largest},
          {fmt::format("picture.border_{}_ratio", border.key), worst.ratio},
          {fmt::format("picture.border_{}_cover", border.key), cover_spread}};
}

}  // namespace

std::vector<Measurement> bench_spline_border(const BenchOptions& options) {
  return measure(kBorders[0], options);
}
std::vector<Measurement> bench_strip_border(const BenchOptions& options) {
  return measure(kBorders[1], options);
}
std::vector<Measurement> bench_flat_border(const BenchOptions& options) {
  return measure(kBorders[2], options);
}

}  // namespace prairie
