// The command line as a whole: global options, commands, and what is wrong with a line that cannot be
// understood.
#pragma once

#include <functional>

#include "app/terminal/global_options.h"

namespace prairie {

struct CommandLine {
  GlobalOptions globals;
  std::function<int(const GlobalOptions&)> run;  // of the command, help, version or list of devices asked for
};

/// Nothing runs while the line is still being read. Throws UsageError.
CommandLine read_command_line(int argc, const char* const* argv);

}  // namespace prairie
