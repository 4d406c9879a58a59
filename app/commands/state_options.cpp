#include "app/commands/state_options.h"

#include <fmt/format.h>

#include <cmath>

#include "app/outputs/outputs.h"
#include "app/scenes/world_time.h"
#include "app/terminal/usage_error.h"
#include "files/input_file.h"
#include "world/motion.h"
#include "world/state_file.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr const char* kTime = "--time";

void advance_to_asked_time(double time_s, World& world) {
  if (std::llround(time_s * static_cast<double>(kTicksPerS)) < world.motion().ticks())
    throw UsageError(kTime, fmt::format("{} s", time_s),
                     fmt::format("{} s or later, the time of the loaded state", world.time_s()));
  advance_to(world, time_s);
}

}  // namespace

CommandOption time_option(StateOptions& options) {
  return {.names = kTime,
          .type = "S",
          .help = "Seconds after the scene's beginning (0, or the loaded state's)",
          .target = number_into(options.time_s, 0.0, kMaxTimeS)};
}

CommandOption load_state_option(StateOptions& options) {
  return {.names = "--load-state",
          .type = "FILE",
          .help = "Begin with a state that --save-state wrote for the same scene",
          .target = text_into(options.load)};
}

CommandOption save_state_option(StateOptions& options) {
  return {.names = "--save-state",
          .type = "FILE",
          .help = "Write the state of the time that is reached, to go on from",
          .target = text_into(options.save)};
}

void begin_as_asked(const StateOptions& options, World& world) {
  if (options.save) check_output_file(*options.save);
  if (options.load) world.load_state(read_input(*options.load, "", kMostStateBytes), options.load->string());
  if (options.time_s) advance_to_asked_time(*options.time_s, world);
}

void save_asked_state(const StateOptions& options, const World& world) {
  if (options.save) write_output(*options.save, world.saved_state());
}

}  // namespace prairie
