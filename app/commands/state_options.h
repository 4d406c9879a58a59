// `--time`, `--load-state` and `--save-state`: a command that steps a world may begin later, or where an
// earlier one ended.
#pragma once

#include <filesystem>
#include <optional>

#include "app/commands/command.h"

namespace prairie {

class World;

struct StateOptions {
  std::optional<double> time_s;
  std::optional<std::filesystem::path> load;
  std::optional<std::filesystem::path> save;
};

/// What they set must live as long as the command.
CommandOption time_option(StateOptions& options);
CommandOption load_state_option(StateOptions& options);
CommandOption save_state_option(StateOptions& options);

/// Loads the state that is asked for, if one is, and steps on to the time that is asked for, if one is. To be
/// called before long work: it also makes sure that the state can be saved where that is asked for. Throws
/// BadInput, OutputFailure; UsageError where that time is over.
void begin_as_asked(const StateOptions& options, World& world);

/// Saves the state, if that is asked for. Throws OutputFailure, OverBudget.
void save_asked_state(const StateOptions& options, const World& world);

}  // namespace prairie
