#include "app/commands/state_options.h"

#include <fmt/format.h>

#include <cmath>

#include "app/outputs/outputs.h"
#include "app/scenes/world_time.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "files/input_file.h"
#include "world/state_file.h"

namespace prairie {

void add_state_options(CLI::App& command, StateOptions& options) {
  command
      .add_option("--load-state", options.load,
                  "Begin with a state that --save-state wrote for the same scene")
      ->type_name("FILE");
  command
      .add_option("--save-state", options.save, "Write the state of the time that is reached, to go on from")
      ->type_name("FILE");
}

void load_asked_state(const StateOptions& options, World& world) {
  if (options.save) check_output_file(*options.save);
  if (!options.load) return;
  world.load_state(read_input(*options.load, "", kMostStateBytes), options.load->string());
}

void save_asked_state(const StateOptions& options, const World& world) {
  if (options.save) write_output(*options.save, world.saved_state());
}

void add_time_option(CLI::App& command, std::optional<double>& time_s) {
  command
      .add_option_function<std::string>(
          "--time",
          [&time_s](const std::string& text) { time_s = number_option("--time", text, 0.0, kMaxTimeS); },
          "Seconds after the scene's beginning (0, or the loaded state's)")
      ->type_name("S");
}

void advance_to_asked_time(const std::optional<double>& time_s, World& world) {
  if (!time_s) return;
  if (std::llround(*time_s * static_cast<double>(kTicksPerS)) < world.motion().ticks())
    throw UsageError("--time", fmt::format("{} s", *time_s),
                     fmt::format("{} s or later, the time of the loaded state", world.time_s()));
  advance_to(world, *time_s);
}

}  // namespace prairie
