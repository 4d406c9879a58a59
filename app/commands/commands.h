// The commands of the program, each in a file of its own.
#pragma once

#include <vector>

#include "app/commands/command.h"

namespace prairie {

Command new_command();
Command info_command();
Command render_command();
Command record_command();
Command export_command();
Command plant_command();
Command view_command();
Command walk_command();
Command bench_command();

/// In the order of the program's help.
std::vector<Command> all_commands();

}  // namespace prairie
