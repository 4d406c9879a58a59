// A command of the program as plain data: what its line may hold, what its help says, and what it does.
// command_line.cpp reads lines by it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/commands/option_target.h"
#include "app/terminal/global_options.h"

namespace prairie {

struct CommandOption {
  const char* names;      // "--tier", "-o,--output"; without dashes, an argument known by its place
  const char* type = "";  // of its value, as help shows it; flags have none
  std::string help = {};
  OptionTarget target;
  bool is_required = false;
  bool is_hidden = false;          // in help
  const char* needs = nullptr;     // the name of an option before it that must be there, too
  const char* excludes = nullptr;  // the name of an option before it that must not
};

struct Command {
  std::string name;
  std::string summary;
  std::vector<CommandOption> options = {};
  std::string footer = {};  // of its help: examples
  /// Runs it once all of the line has been read into the targets; it keeps alive what they point to. Returns
  /// the exit code.
  std::function<int(const GlobalOptions&)> run = {};
};

}  // namespace prairie
