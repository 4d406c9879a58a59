#include "bench/bench.h"

#include <array>
#include <string_view>

#include "bench/benches.h"

namespace prairie {
namespace {

struct Bench {
  std::string_view name;
  double (*measure)(const BenchOptions&);
};

constexpr std::array kBenches{
    Bench{"planting.cpu_blades_per_s_core", planting_cpu_blades_per_s_core},
    Bench{"planting.gpu_ns_per_blade", planting_gpu_ns_per_blade},
};

}  // namespace

std::vector<std::string> bench_names() {
  std::vector<std::string> names;
  for (const Bench& bench : kBenches) names.emplace_back(bench.name);
  return names;
}

std::vector<Measurement> run_benches(const std::string& prefix, const BenchOptions& options) {
  std::vector<Measurement> measurements;
  for (const Bench& bench : kBenches) {
    if (!bench.name.starts_with(prefix)) continue;
    measurements.push_back({std::string(bench.name), bench.measure(options)});
  }
  return measurements;
}

}  // namespace prairie
