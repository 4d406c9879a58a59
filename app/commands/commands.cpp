#include "app/commands/commands.h"

namespace prairie {

std::vector<Command> all_commands() {
  return {new_command(),   info_command(), render_command(), record_command(), export_command(),
          plant_command(), view_command(), walk_command(),   bench_command()};
}

}  // namespace prairie
