// Measurements that the program makes of itself (`prairie bench`) and that docs/measurements.md quotes. A
// bench is a run that yields one or several of them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

struct BenchOptions {
  std::optional<std::string> device;    // as for HeadlessContext
  std::filesystem::path shader_folder;  // as for Renderer
  std::ostream* details = nullptr;      // where benches tell of single cases, if a person wants to know
};

struct Measurement {
  std::string name;  // "NAME.what_unit"
  double value = 0.0;
  std::string note = {};  // what was found, in words instead of a number, if not empty
};

/// The names of all measurements, in the order in which they are made.
std::vector<std::string> bench_names();

/// The names of those that begin with `prefix`; without a prefix, of those that do not take minutes.
std::vector<std::string> chosen_bench_names(const std::string& prefix);

/// Runs the benches that chosen measurements belong to, and returns those measurements.
std::vector<Measurement> run_benches(const std::string& prefix, const BenchOptions& options);

/// What a child process does for a bench of its parent, which left it files in `folder`
/// (bench/scale_child.h).
std::vector<Measurement> run_bench_child(const std::string& task, const std::filesystem::path& folder,
                                         const BenchOptions& options);

}  // namespace prairie
