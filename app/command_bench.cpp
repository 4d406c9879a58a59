// `prairie bench`: measurements of this machine, as a table or as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/installed_files.h"
#include "app/option_values.h"
#include "app/usage_error.h"
#include "bench/bench.h"
#include "maps/error.h"
#include "render/context.h"

namespace prairie {
namespace {

struct BenchCommandOptions {
  std::string prefix;
  bool json = false;
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

int print_measurements(const BenchCommandOptions& options, const GlobalOptions& globals) {
  const std::vector<std::string> names = bench_names();
  if (std::ranges::none_of(names,
                           [&](const std::string& name) { return name.starts_with(options.prefix); })) {
    throw UsageError("NAME", options.prefix + did_you_mean(options.prefix, names),
                     fmt::format("the beginning of one of {}", fmt::join(names, ", ")));
  }
  BenchOptions bench_options;
  bench_options.device = globals.device;
  bench_options.shader_folder = shader_folder();
  const std::vector<Measurement> measurements = run_benches(options.prefix, bench_options);
  const std::string machine = machine_name();
  const std::string renderer = headless_renderer_name(globals.device);
  if (options.json) {
    nlohmann::ordered_json json;
    for (const Measurement& measurement : measurements) json[measurement.name] = measurement.value;
    json["machine"] = machine;
    json["renderer"] = renderer;
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return kExitFine;
  }
  std::size_t widest = 0;
  for (const Measurement& measurement : measurements) widest = std::max(widest, measurement.name.size());
  for (const Measurement& measurement : measurements) {
    fmt::print("{:<{}}  {:>14.6g}\n", measurement.name, widest, measurement.value);
  }
  fmt::print("machine   {}\nrenderer  {}\n", machine, renderer);
  return kExitFine;
}

}  // namespace

void add_bench_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("bench", "Measures this machine; each measurement takes at most a minute");
  auto options = std::make_shared<BenchCommandOptions>();
  command->add_option("NAME", options->prefix, "The beginning of the keys to measure (all)")->type_name("");
  command->add_flag("--json", options->json, "Print one flat JSON object");
  command->footer(
      "Examples:\n"
      "  prairie bench\n"
      "  prairie bench planting --json");
  command->callback([options, &globals, &chosen] {
    chosen = [options, &globals] { return print_measurements(*options, globals); };
  });
}

}  // namespace prairie
