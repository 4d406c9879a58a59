// The command line as a whole: global options, commands, and what is wrong with a line that cannot be
// understood.
#pragma once

#include <memory>
#include <string>

#include "app/commands/commands.h"

namespace prairie {

struct CommandLine {
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Reads the line, after which `chosen` is what to run (help, version and lists of devices included).
  /// Throws UsageError.
  void read(int argc, const char* const* argv);

  GlobalOptions globals;
  Command chosen;

 private:
  bool list_devices_ = false;
  std::unique_ptr<CLI::App> app_;
};

}  // namespace prairie
