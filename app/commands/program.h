// The program: reads the command line, runs one command, and turns whatever went wrong into one line on
// stderr and an exit code.
#pragma once

namespace prairie {

/// Returns the exit code (app/terminal/exit_code.h) and throws nothing.
int run_program(int argc, const char* const* argv);

}  // namespace prairie
