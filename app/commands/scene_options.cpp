#include "app/commands/scene_options.h"

namespace prairie {

CommandOption scene_folder_option(std::filesystem::path& folder) {
  return {.names = "DIR", .help = "The scene's folder", .target = text_into(folder), .is_required = true};
}

CommandOption chosen_tiles_option(std::optional<TileRange>& tiles) {
  return {.names = "--tiles",
          .type = "i0,j0,i1,j1",
          .help = "From tile i0,j0 to i1,j1, both inclusive; 0,0 is south-west, i east, j north (all)",
          .target = parsed_into(tiles, tiles_option)};
}

}  // namespace prairie
