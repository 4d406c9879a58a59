// Whether tiers agree: each tier, at the distance at which it gives way to the next, against the all-3D
// picture of the same grass, both with 16 samples a pixel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "bench/benches.h"
#include "bench/tier_scene.h"
#include "pictures/picture_metrics.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr int kPasses = 4;  // of 4 samples a pixel

struct Disagreement {
  double color = 0.0;    // largest error of a channel's mean, relative
  double cover = 0.0;    // error of the mean cover
  double texture = 0.0;  // largest relative error of the deviation of luminance at 4, 8 and 16 pixels
};

// A band of ground, seen in one tier.
struct Band {
  const char* key;  // of the measurements that it counts for
  Tier tier;
  double near_m, far_m;
};

struct View {
  double eye_height_m;
  glm::ivec2 size_px;
  glm::dvec2 extent_m;
  std::vector<Band> bands;
};

const std::vector<View>& views() {
  static const std::vector<View> all = {
      {1.7,
       {256, 560},
       {16.0, 26.0},
       {{"spline", Tier::kAuto, 3.6, 4.4},
        {"hermite", Tier::kAuto, 5.5, 7.0},
        {"hermite", Tier::kAuto, 11.0, 14.0},
        {"strip", Tier::kAuto, 14.5, 20.0},
        {"strip", Tier::kStrip, 14.5, 20.0}}},
      // Raised, so that the band is high enough for blocks of 16 pixels.
      {12.0,
       {96, 240},
       {48.0, 140.0},
       {{"strip", Tier::kStrip, 75.0, 96.0}, {"flat", Tier::kFlat, 94.0, 128.0}}},
  };
  return all;
}

Disagreement compare(const Picture& reference, const Picture& picture, const PixelRect& rect,
                     std::ostream* details) {
  const LinearImage wanted{reference.width, reference.height, reference.linear_rgb};
  const LinearImage found{picture.width, picture.height, picture.linear_rgb};
  Disagreement result;
  const glm::dvec3 error = mean_color(found, rect) / mean_color(wanted, rect) - 1.0;
  const double cover = mean_cover(picture, rect) - mean_cover(reference, rect);
  result.color = std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)});
  result.cover = std::abs(cover);
  std::string textures;
  for (const int block_px : {4, 8, 16}) {
    const double ratio =
        luminance_deviation(found, rect, block_px) / luminance_deviation(wanted, rect, block_px);
    result.texture = std::max(result.texture, std::abs(ratio - 1.0));
    textures += fmt::format(" {:.2f} of {:.4f}", ratio, luminance_deviation(wanted, rect, block_px));
  }
  if (details) {
    *details << fmt::format("color {:+.3f} {:+.3f} {:+.3f}  cover {:+.3f} of {:.3f}  texture{}\n", error.x,
                            error.y, error.z, cover, mean_cover(reference, rect), textures);
  }
  return result;
}

Picture drawn(Renderer& renderer, const Camera& camera, Tier tier) {
  FrameOptions options;
  options.tier = tier;
  options.msaa = true;
  return renderer.render(camera, options, kPasses);
}

}  // namespace

std::vector<Measurement> bench_tier_pictures(const BenchOptions& options) {
  const HeadlessContext context(options.device);
  std::map<std::string, Disagreement> worst;
  for (const View& view : views()) {
    for (const TierScene& tier_scene : tier_scenes(view.extent_m)) {
      const World world(tier_scene.scene, {});
      Renderer renderer(world, options.shader_folder);
      const Camera camera = tier_camera(tier_scene, view.eye_height_m, view.size_px);
      const Picture reference = drawn(renderer, camera, Tier::kSpline);
      std::map<Tier, Picture> pictures;
      for (const Band& band : view.bands) {
        if (!pictures.contains(band.tier)) pictures.emplace(band.tier, drawn(renderer, camera, band.tier));
        const int top = row_of_ground(camera, view.eye_height_m, band.far_m);
        const int bottom = std::min(row_of_ground(camera, view.eye_height_m, band.near_m), view.size_px.y);
        if (options.details)
          *options.details << fmt::format("{:<30} {:<8} {:5.1f} m  ", tier_scene.name, band.key, band.near_m);
        const Disagreement found = compare(reference, pictures.at(band.tier),
                                           {0, top, view.size_px.x, bottom - top}, options.details);
        Disagreement& sum = worst[band.key];
        sum.color = std::max(sum.color, found.color);
        sum.cover = std::max(sum.cover, found.cover);
        sum.texture = std::max(sum.texture, found.texture);
      }
    }
  }
  std::vector<Measurement> measurements;
  for (const char* key : {"spline", "hermite", "strip", "flat"}) {
    measurements.push_back({fmt::format("picture.{}_color_error", key), worst[key].color});
    measurements.push_back({fmt::format("picture.{}_cover_error", key), worst[key].cover});
    measurements.push_back({fmt::format("picture.{}_texture_error", key), worst[key].texture});
  }
  return measurements;
}

}  // namespace prairie
