#include "bench/bench.h"

#include <algorithm>
#include <string_view>

#include "bench/benches.h"
#include "bench/scale_child.h"

namespace prairie {
namespace {

struct Bench {
  std::vector<Measurement> (*measure)(const BenchOptions&);
  std::vector<std::string_view> names;  // of its measurements
  bool takes_minutes = false;           // run only where a prefix asks for it
};

const std::vector<Bench>& benches() {
  static const std::vector<Bench> all = {
      {bench_planting_cpu, {"planting.cpu_blades_per_s_core"}},
      {bench_blade_motion, {"inertial.step_ms_100k", "virtual.step_ms_64x64"}},
      {bench_planting_gpu, {"planting.gpu_ns_per_blade"}},
      {bench_treading, {"treading.step_ms_1000"}},
      {bench_wind_nodes, {"wind.nodes_ms_64x64"}},
      {bench_gjk,
       {"gjk.pairs_per_s", "gjk.warm_pairs_per_s", "gjk.fcl_pairs_per_s", "gjk.ccd_pairs_per_s", "gjk.ratio",
        "gjk.warm_ratio"}},
      {bench_walker_steps, {"walkers.step_ms_1k", "walkers.step_ms_10k", "walkers.step_growth"}},
      {bench_walker_frames, {"walkers.frame_ms_200", "walkers.frame_ratio_200"}},
      {bench_scale_walk,
       {"scale.ground", "scale.frame_ms_median", "scale.frame_ms_p95", "scale.probe_ms",
        "scale.frame_per_probe", "scale.plan_ms", "scale.blades_in_scene", "scale.blades_planted_in_view",
        "scale.blades_drawn", "scale.blades_in_strips", "scale.share_spline", "scale.share_hermite",
        "scale.share_strip", "scale.share_flat", "scale.share_floor", "scale.limit_ratio"}},
      {bench_scale_variants,
       {"scale.density_100_ms", "scale.density_10000_ms", "scale.density_ratio", "scale.wind_ratio",
        "scale.repeat10_ratio"}},
      {bench_table1,
       {"table1.a_ms", "table1.b_ms", "table1.c_ms", "table1.c_per_a", "table1.inertial_blades"}},
      {bench_scale_processes, {"scale.startup_s", "scale.peak_rss_mb", "scale.repeat10_extra_mb"}},
      {bench_tier_pictures,
       {"picture.spline_color_error", "picture.spline_cover_error", "picture.spline_texture_error",
        "picture.hermite_color_error", "picture.hermite_cover_error", "picture.hermite_texture_error",
        "picture.strip_color_error", "picture.strip_cover_error", "picture.strip_texture_error",
        "picture.flat_color_error", "picture.flat_cover_error", "picture.flat_texture_error"},
       true},
      {bench_spline_border,
       {"picture.border_spline_step", "picture.border_spline_ratio", "picture.border_spline_cover"},
       true},
      {bench_strip_border,
       {"picture.border_strip_step", "picture.border_strip_ratio", "picture.border_strip_cover"},
       true},
      {bench_flat_border,
       {"picture.border_flat_step", "picture.border_flat_ratio", "picture.border_flat_cover"},
       true},
      {bench_scale_picture,
       {"picture.scale_color_error", "picture.scale_cover_error", "picture.scale_flip"},
       true},
  };
  return all;
}

bool is_chosen(const Bench& bench, std::string_view name, std::string_view prefix) {
  return name.starts_with(prefix) && !(prefix.empty() && bench.takes_minutes);
}

}  // namespace

std::vector<std::string> bench_names() {
  std::vector<std::string> names;
  for (const Bench& bench : benches()) names.insert(names.end(), bench.names.begin(), bench.names.end());
  return names;
}

std::vector<std::string> chosen_bench_names(const std::string& prefix) {
  std::vector<std::string> names;
  for (const Bench& bench : benches()) {
    for (const std::string_view name : bench.names) {
      if (is_chosen(bench, name, prefix)) names.emplace_back(name);
    }
  }
  return names;
}

std::vector<Measurement> run_benches(const std::string& prefix, const BenchOptions& options) {
  std::vector<Measurement> measurements;
  for (const Bench& bench : benches()) {
    const auto chosen = [&](std::string_view name) { return is_chosen(bench, name, prefix); };
    if (std::ranges::none_of(bench.names, chosen)) continue;
    for (Measurement& measurement : bench.measure(options)) {
      if (chosen(measurement.name)) measurements.push_back(std::move(measurement));
    }
  }
  return measurements;
}

std::vector<Measurement> run_bench_child(const std::string& task, const std::filesystem::path& folder,
                                         const BenchOptions& options) {
  return run_scale_child(task, folder, options);
}

}  // namespace prairie
