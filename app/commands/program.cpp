#include "app/commands/program.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <exception>
#include <new>
#include <optional>
#include <string_view>

#include "app/commands/command_line.h"
#include "app/commands/kept_memory.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/interruption.h"
#include "app/terminal/messages.h"
#include "app/terminal/usage_error.h"
#include "files/error.h"
#include "world/decoder.h"
#include "world/scene/scene.h"

namespace prairie {
namespace {

int run(int argc, const char* const* argv) {
  if (argc == 2 && std::string_view(argv[1]) == kDecodeArgument) {
    serve_requests(decoding_work());
    return kExitFine;
  }
  // Forked off while there is one thread and hardly any memory to copy.
  WorkerProcess decoder(decoding_work());
  keep_freed_memory();
  watch_for_interruption();
  CommandLine line = read_command_line(argc, argv);
  line.globals.decoder = &decoder;
  std::optional<tbb::global_control> thread_limit;
  if (line.globals.threads) {
    thread_limit.emplace(tbb::global_control::max_allowed_parallelism,
                         static_cast<std::size_t>(*line.globals.threads));
  }
  const int exit_code = line.run(line.globals);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw OutputFailure("standard output", "", "a write error", "room to write");
  }
  return exit_code;
}

int fail(int exit_code, const std::exception& error) {
  say_fault(error.what());
  return exit_code;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return fail(kExitUsage, error);
  } catch (const BadOverride& error) {
    return fail(kExitUsage, error);
  } catch (const BadInput& error) {
    return fail(kExitBadInput, error);
  } catch (const NoSuitableOpenGl& error) {
    return fail(kExitNoOpenGl, error);
  } catch (const std::bad_alloc&) {
    say_fault("found no memory left, expected enough for this scene; see --max-memory");
    return kExitFailure;
  } catch (const std::exception& error) {
    return fail(kExitFailure, error);
  }
}

}  // namespace prairie
