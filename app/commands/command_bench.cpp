// `prairie bench`: measurements of this machine, as a table or as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include "app/commands/commands.h"
#include "app/scenes/installed_files.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "bench/bench.h"
#include "files/error.h"
#include "files/joined.h"
#include "files/json_text.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

struct BenchCommandOptions {
  std::string prefix;
  bool json = false;
  bool details = false;
  std::string child_folder;  // not empty: this is a bench's own child process, and `prefix` its task
};

/// "4 × Intel(R) Xeon(R) …".
std::string machine_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string model = "unknown processor";
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      model = line.substr(colon + 2);
      break;
    }
  }
  return fmt::format("{} × {}", std::thread::hardware_concurrency(), model);
}

std::string headless_renderer_name(const std::optional<std::string>& device) {
  try {
    const HeadlessContext context(device);
    return renderer_name();
  } catch (const NoSuitableOpenGl&) {
    return "none";
  }
}

void print_json(const std::vector<Measurement>& measurements, const std::string& machine,
                const std::string& renderer) {
  JsonObject json;
  for (const Measurement& measurement : measurements) {
    if (measurement.note.empty()) {
      json.push_back({measurement.name, measurement.value});
    } else {
      json.push_back({measurement.name, measurement.note});
    }
  }
  json.push_back({"machine", machine});
  json.push_back({"renderer", renderer});
  fmt::print("{}\n", json_text(json));
}

void print_table(const std::vector<Measurement>& measurements, const std::string& machine,
                 const std::string& renderer) {
  std::size_t widest = 0;
  for (const Measurement& measurement : measurements) widest = std::max(widest, measurement.name.size());
  for (const Measurement& measurement : measurements) {
    if (measurement.note.empty()) {
      fmt::print("{:<{}}  {:>14.6g}\n", measurement.name, widest, measurement.value);
    } else {
      fmt::print("{:<{}}  {}\n", measurement.name, widest, measurement.note);
    }
  }
  fmt::print("machine   {}\nrenderer  {}\n", machine, renderer);
}

/// Lines "NAME VALUE", for the process that started this one.
int print_for_parent(const std::vector<Measurement>& measurements) {
  for (const Measurement& measurement : measurements)
    fmt::print("{} {}\n", measurement.name, measurement.value);
  return kExitFine;
}

int measure(const BenchCommandOptions& options, const GlobalOptions& globals) {
  BenchOptions bench_options;
  bench_options.device = globals.device;
  bench_options.shader_folder = shader_folder();
  if (options.details) bench_options.details = &std::cerr;
  if (!options.child_folder.empty()) {
    return print_for_parent(run_bench_child(options.prefix, options.child_folder, bench_options));
  }
  if (chosen_bench_names(options.prefix).empty()) {
    const std::vector<std::string> names = bench_names();
    throw UsageError("NAME", options.prefix + did_you_mean(options.prefix, names),
                     "the beginning of one of " + joined(names, ", "));
  }
  const std::vector<Measurement> measurements = run_benches(options.prefix, bench_options);
  const auto print = options.json ? print_json : print_table;
  print(measurements, machine_name(), headless_renderer_name(globals.device));
  return kExitFine;
}

}  // namespace

Command bench_command() {
  const auto options = std::make_shared<BenchCommandOptions>();
  Command command{"bench", "Measures this machine, in about two minutes"};
  command.options = {
      {.names = "NAME",
       .help = "The beginning of the keys to measure (all but those that take minutes)",
       .target = text_into(options->prefix)},
      {.names = "--json", .help = "Print one flat JSON object", .target = &options->json},
      {.names = "--details", .help = "Tell of single cases on stderr", .target = &options->details},
      // For its own child processes.
      {.names = "--child", .type = "TEXT", .target = text_into(options->child_folder), .is_hidden = true},
  };
  command.footer =
      "Examples:\n"
      "  prairie bench\n"
      "  prairie bench scale.frame --details\n"
      "  prairie bench planting --json";
  command.run = [options](const GlobalOptions& globals) { return measure(*options, globals); };
  return command;
}

}  // namespace prairie
