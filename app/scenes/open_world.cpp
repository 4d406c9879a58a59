#include "app/scenes/open_world.h"

#include <utility>

#include "app/terminal/messages.h"
#include "world/world.h"

namespace prairie {

World open_world(const std::filesystem::path& folder, const GlobalOptions& globals,
                 std::optional<Gait> gait) {
  WorldOptions options;
  options.gait = std::move(gait);
  options.seed = globals.seed;
  options.memory_budget_bytes = globals.max_memory_bytes;
  options.decoder = globals.decoder;
  World world(read_scene(folder, globals.overrides), options);
  if (!globals.quiet) {
    for (const Warning& warning : world.warnings()) say_warning(warning.text);
  }
  return world;
}

}  // namespace prairie
