#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_child.h"
#include "bench/scale_folder.h"
#include "bench/scale_ground.h"
#include "bench/scale_limit.h"
#include "bench/scale_probe.h"
#include "bench/scale_scene.h"
#include "bench/scale_shares.h"
#include "bench/scale_target.h"
#include "render/context.h"
#include "render/renderer.h"

namespace prairie {
namespace {

constexpr int kWarmUpFrames = 3;
constexpr int kFramesPerProbe = 4;
constexpr int kVariantFrames = 30;
constexpr int kLimitFrames = 30;

/// The value below which the given share of the values lies.
double quantile(std::vector<double> values, double share) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, nth);
  return *nth;
}

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

/// A world on its walk.
struct Walker {
  Walker(const ScaleGround& the_ground, const ScaleVariant& variant, const BenchOptions& options)
      : ground(the_ground), world(scale_world(the_ground, variant)), renderer(world, options.shader_folder) {}

  Camera camera(int frame) const { return walk_camera(world, ground, frame); }

  void step(int frame, const OffscreenTarget& target) {
    const Camera seen = camera(frame);
    const auto start = std::chrono::steady_clock::now();
    statistics = renderer.draw(seen, {}, target.framebuffer());
    glFinish();
    if (frame < 0) return;
    frame_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    plan_ms.push_back(statistics.plan_ms);
  }

  ScaleGround ground;
  World world;
  Renderer renderer;
  FrameStatistics statistics;  // of the last frame
  std::vector<double> frame_ms;
  std::vector<double> plan_ms;
};

void measure_walk(Walker& walker, const OffscreenTarget& target, const BenchOptions& options,
                  std::vector<Measurement>& measurements) {
  const BladeProbe probe;
  probe.measure_ms(target);
  std::vector<double> probe_ms;
  for (int frame = -kWarmUpFrames; frame < kWalkFrames; ++frame) {
    walker.step(frame, target);
    if (frame >= 0 && frame % kFramesPerProbe == 0) probe_ms.push_back(probe.measure_ms(target));
  }
  const double frame_ms = median(walker.frame_ms);
  measurements.push_back({"scale.frame_ms_median", frame_ms});
  measurements.push_back({"scale.frame_ms_p95", quantile(walker.frame_ms, 0.95)});
  measurements.push_back({"scale.probe_ms", median(probe_ms)});
  measurements.push_back({"scale.frame_per_probe", frame_ms / median(probe_ms)});
  measurements.push_back({"scale.plan_ms", median(walker.plan_ms)});
  if (options.details == nullptr) return;
  *options.details << "frame ms:";
  for (const double ms : walker.frame_ms) *options.details << fmt::format(" {:.1f}", ms);
  *options.details << "\nprobe ms:";
  for (const double ms : probe_ms) *options.details << fmt::format(" {:.1f}", ms);
  *options.details << '\n';
}

void count_blades(const Walker& walker, const BenchOptions& options, std::vector<Measurement>& measurements) {
  const FrameStatistics& statistics = walker.statistics;
  measurements.push_back({"scale.blades_in_scene", expected_blades(walker.world)});
  measurements.push_back(
      {"scale.blades_planted_in_view", static_cast<double>(statistics.blades_planted_in_view)});
  measurements.push_back({"scale.blades_drawn", static_cast<double>(statistics.blades_drawn)});
  measurements.push_back({"scale.blades_in_strips", static_cast<double>(statistics.strip.blades)});
  if (options.details == nullptr) return;
  const auto tell = [&](const char* name, const TierStatistics& tier) {
    *options.details << fmt::format("{}: {} blades, {} triangles\n", name, tier.blades, tier.triangles);
  };
  tell("spline", statistics.spline);
  tell("hermite", statistics.hermite);
  tell("strip", statistics.strip);
  tell("flat", statistics.flat);
}

void measure_shares(Walker& walker, std::vector<Measurement>& measurements) {
  const TierShares shares = tier_shares(walker.renderer, walker.camera(kWalkFrames - 1));
  measurements.push_back({"scale.share_spline", shares.spline});
  measurements.push_back({"scale.share_hermite", shares.hermite});
  measurements.push_back({"scale.share_strip", shares.strip});
  measurements.push_back({"scale.share_flat", shares.flat});
  measurements.push_back({"scale.share_floor", shares.floor});
}

/// Frames in turn with their blades alone, drawn plainly.
void measure_limit(Walker& walker, const OffscreenTarget& target, const BenchOptions& options,
                   std::vector<Measurement>& measurements) {
  FrameLimit limit(walker.world, options.shader_folder);
  std::vector<double> limit_ms;
  walker.frame_ms.clear();
  for (int frame = 0; frame < kLimitFrames; ++frame) {
    limit.prepare(walker.camera(frame), target);
    limit_ms.push_back(limit.measure_ms(target));
    walker.step(frame, target);
  }
  measurements.push_back({"scale.limit_ratio", median(walker.frame_ms) / median(limit_ms)});
  if (options.details == nullptr) return;
  *options.details << fmt::format("limit {:.1f} ms, frame {:.1f} ms\n", median(limit_ms),
                                  median(walker.frame_ms));
}

/// The same walk through other fields, frame by frame in turn with the plain one.
void measure_variants(Walker& plain, const OffscreenTarget& target, const BenchOptions& options,
                      std::vector<Measurement>& measurements) {
  Walker sparse(plain.ground, {.density_factor = 0.1}, options);
  Walker dense(plain.ground, {.density_factor = 10.0}, options);
  Walker repeated(plain.ground, {.repeats = true}, options);
  plain.frame_ms.clear();
  for (int frame = -kWarmUpFrames; frame < kVariantFrames; ++frame) {
    for (Walker* walker : {&plain, &sparse, &dense, &repeated}) walker->step(frame, target);
  }
  measurements.push_back({"scale.density_100_ms", median(sparse.frame_ms)});
  measurements.push_back({"scale.density_10000_ms", median(dense.frame_ms)});
  measurements.push_back({"scale.density_ratio", median(dense.frame_ms) / median(sparse.frame_ms)});
  measurements.push_back({"scale.repeat10_ratio", median(repeated.frame_ms) / median(plain.frame_ms)});
}

void tell_relief(const ScaleGround& ground, std::ostream& details) {
  MapSpec spec;
  spec.file = ground.file;
  const Relief relief = relief_of(read_map(spec, MapMeaning::kHeight, std::uint64_t{1} << 30).grid);
  details << fmt::format(
      "{}: heights ± {:.1f} m, slopes {:.1f}° (median), {:.1f}° (99 %), correlated over {:.0f} m\n",
      ground.name, relief.deviation_m, relief.median_slope_deg, relief.steep_slope_deg, relief.correlation_m);
}

}  // namespace

std::vector<Measurement> bench_scale(const BenchOptions& options) {
  const BenchFolder folder;
  const ScaleGround ground = scale_ground(folder.path());
  if (options.details != nullptr) tell_relief(ground, *options.details);
  const ChildMeasurements alone = run_scale_process(kWalkTask, folder.path(), options);
  const ChildMeasurements repeated = run_scale_process(kRepeatedWalkTask, folder.path(), options);

  std::vector<Measurement> measurements = {{"scale.ground", 0.0, ground.name}};
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  Walker walker(ground, {}, options);
  measure_walk(walker, target, options, measurements);
  count_blades(walker, options, measurements);
  measure_shares(walker, measurements);
  measure_limit(walker, target, options, measurements);
  measure_variants(walker, target, options, measurements);
  measurements.push_back({"scale.startup_s", alone.startup_s});
  measurements.push_back({"scale.peak_rss_mb", alone.peak_rss_mb});
  measurements.push_back({"scale.repeat10_extra_mb", repeated.peak_rss_mb - alone.peak_rss_mb});
  return measurements;
}

}  // namespace prairie
