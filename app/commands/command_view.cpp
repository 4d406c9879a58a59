// `prairie view`: the command line of app/viewer/view.h.
#include <memory>
#include <string>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/window_options.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "app/viewer/actions.h"
#include "app/viewer/key_help.h"
#include "app/viewer/view.h"
#include "world/world.h"

namespace prairie {
namespace {

struct ViewCommandOptions {
  std::filesystem::path folder;
  std::string camera = kDefaultCamera;
  glm::ivec2 size_px{1280, 720};
  ViewerOptions viewer;
};

int view(const ViewCommandOptions& options, const GlobalOptions& globals) {
  World world = open_world(options.folder, globals);
  const Camera start = placed_camera(camera_option(options.camera, world), world, options.size_px);
  ViewerOptions viewer = options.viewer;
  viewer.memory_budget_bytes = globals.max_memory_bytes;
  view_world(world, start, viewer);
  return kExitFine;
}

}  // namespace

Command view_command() {
  const auto options = std::make_shared<ViewCommandOptions>();
  Command command{"view", "Opens a window to fly over the moving meadow, walk through it and play with it"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "--camera",
       .type = "NAME|NUMBERS",
       .help = "Where to start: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)",
       .target = text_into(options->camera)},
      {.names = "--size",
       .type = "WxH",
       .help = "The window's pixels at first (1280x720)",
       .target = parsed_into(options->size_px, size_option)},
      picture_tier_option(options->viewer.tier),
      {.names = "--msaa", .help = "Smooth edges with 4 samples per pixel", .target = &options->viewer.msaa},
      {.names = "--paused",
       .help = "Time stands still at first; P lets it go on",
       .target = &options->viewer.paused},
      window_frames_option(options->viewer),
      window_screenshot_option(options->viewer),
  };
  command.footer = "Keys:\n" + key_table(viewer_actions()) +
                   "Examples:\n"
                   "  prairie view examples/meadow\n"
                   "  prairie view examples/meadow --camera 64,64,+12,0,-20 --size 1920x1080";
  command.run = [options](const GlobalOptions& globals) { return view(*options, globals); };
  return command;
}

}  // namespace prairie
