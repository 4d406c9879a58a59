// The walk itself: how long its frames take, against a probe of the machine and against the least that their
// blades could cost, and what they show.
#include <fmt/format.h>

#include <ostream>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_folder.h"
#include "bench/scale_limit.h"
#include "bench/scale_probe.h"
#include "bench/scale_shares.h"
#include "bench/timing.h"
#include "bench/walking_eye.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

constexpr int kFramesPerProbe = 4;
constexpr int kLimitFrames = 30;

void tell_times(const char* what, const std::vector<double>& times_ms, std::ostream& details) {
  details << what << " ms:";
  for (const double ms : times_ms) details << fmt::format(" {:.1f}", ms);
  details << '\n';
}

void measure_walk(WalkingEye& walker, const OffscreenTarget& target, const BenchOptions& options,
                  std::vector<Measurement>& measurements) {
  const BladeProbe probe;
  probe.measure_ms(target);
  std::vector<double> probe_ms;
  for (int frame = -kWarmUpFrames; frame < kWalkFrames; ++frame) {
    walker.step(frame, target);
    if (frame >= 0 && frame % kFramesPerProbe == 0) probe_ms.push_back(probe.measure_ms(target));
  }
  const double frame_ms = median(walker.frame_ms());
  measurements.push_back({"scale.frame_ms_median", frame_ms});
  measurements.push_back({"scale.frame_ms_p95", quantile(walker.frame_ms(), 0.95)});
  measurements.push_back({"scale.probe_ms", median(probe_ms)});
  measurements.push_back({"scale.frame_per_probe", frame_ms / median(probe_ms)});
  measurements.push_back({"scale.plan_ms", median(walker.plan_ms())});
  if (options.details == nullptr) return;
  tell_times("frame", walker.frame_ms(), *options.details);
  tell_times("probe", probe_ms, *options.details);
}

void count_blades(const WalkingEye& walker, const BenchOptions& options,
                  std::vector<Measurement>& measurements) {
  const FrameStatistics& statistics = walker.statistics();
  measurements.push_back({"scale.blades_in_scene", expected_blades(walker.world())});
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
  for (const StageTime& stage : statistics.gpu_times) {
    *options.details << fmt::format("{}: {:.2f} ms on the device\n", stage.name, stage.ms);
  }
}

void measure_shares(WalkingEye& walker, std::vector<Measurement>& measurements) {
  const TierShares shares = tier_shares(walker.renderer(), walker.camera(kWalkFrames - 1));
  measurements.push_back({"scale.share_spline", shares.spline});
  measurements.push_back({"scale.share_hermite", shares.hermite});
  measurements.push_back({"scale.share_strip", shares.strip});
  measurements.push_back({"scale.share_flat", shares.flat});
  measurements.push_back({"scale.share_floor", shares.floor});
}

/// Frames in turn with their blades alone, drawn plainly.
void measure_limit(WalkingEye& walker, const OffscreenTarget& target, const BenchOptions& options,
                   std::vector<Measurement>& measurements) {
  FrameLimit limit(walker.world(), options.shader_folder);
  std::vector<double> limit_ms;
  walker.begin_again();
  for (int frame = 0; frame < kLimitFrames; ++frame) {
    limit.prepare(walker.camera(frame), target);
    limit_ms.push_back(limit.measure_ms(target));
    walker.step(frame, target);
  }
  measurements.push_back({"scale.limit_ratio", median(walker.frame_ms()) / median(limit_ms)});
  if (options.details == nullptr) return;
  *options.details << fmt::format("limit {:.1f} ms, frame {:.1f} ms\n", median(limit_ms),
                                  median(walker.frame_ms()));
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

std::vector<Measurement> bench_scale_walk(const BenchOptions& options) {
  const BenchFolder folder;
  const ScaleGround ground = scale_ground(folder.path());
  if (options.details != nullptr) tell_relief(ground, *options.details);
  std::vector<Measurement> measurements = {{"scale.ground", 0.0, ground.name}};
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  WalkingEye walker(ground, {}, options);
  measure_walk(walker, target, options, measurements);
  count_blades(walker, options, measurements);
  measure_shares(walker, measurements);
  measure_limit(walker, target, options, measurements);
  return measurements;
}

}  // namespace prairie
