// `--load-state` and `--save-state`: a command that steps a world may begin where an earlier one ended.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "world/world.h"

namespace prairie {

struct StateOptions {
  std::optional<std::filesystem::path> load;
  std::optional<std::filesystem::path> save;
};

/// Adds both; `options` must live as long as the command.
void add_state_options(CLI::App& command, StateOptions& options);

/// Loads the state that is asked for, if one is. To be called before long work: it also makes sure that the
/// state can be saved where that is asked for. Throws BadInput, OutputFailure.
void load_asked_state(const StateOptions& options, World& world);

/// Saves the state, if that is asked for. Throws OutputFailure, OverBudget.
void save_asked_state(const StateOptions& options, const World& world);

/// Adds `--time`; `time_s` must live as long as the command.
void add_time_option(CLI::App& command, std::optional<double>& time_s);

/// Between loading and saving: steps to the time that `--time` gave, or stays. Throws UsageError where that
/// is over.
void advance_to_asked_time(const std::optional<double>& time_s, World& world);

}  // namespace prairie
