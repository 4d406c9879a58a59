// Measurements that the program makes of itself (`prairie bench`) and that docs/measurements.md quotes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

struct BenchOptions {
  std::optional<std::string> device;    // as for HeadlessContext
  std::filesystem::path shader_folder;  // as for Renderer
};

struct Measurement {
  std::string name;  // "NAME.what_unit"
  double value = 0.0;
};

/// The names of all measurements, in the order in which they are made.
std::vector<std::string> bench_names();

/// Makes those measurements whose names begin with `prefix`; each takes at most a minute.
std::vector<Measurement> run_benches(const std::string& prefix, const BenchOptions& options);

}  // namespace prairie
