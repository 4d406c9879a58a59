// The commands of the program. Each adds itself to the command line and, once it has been chosen and all of
// the line has been understood, stores what is to be run; nothing runs while the line is still being read.
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/terminal/global_options.h"

namespace prairie {

/// Returns the exit code.
using Command = std::function<int()>;

void add_new_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_info_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_render_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_record_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_export_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_plant_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_view_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_walk_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);
void add_bench_command(CLI::App& app, const GlobalOptions& globals, Command& chosen);

}  // namespace prairie
