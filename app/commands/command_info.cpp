// `prairie info`: the command line of app/scenes/info.h.
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/scene_options.h"
#include "app/scenes/info_formats.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "world/world.h"

namespace prairie {
namespace {

struct InfoOptions {
  std::filesystem::path folder;
  bool json = false;
};

int print_info(const InfoOptions& options, GlobalOptions globals) {
  globals.quiet = true;  // the report itself holds the warnings
  const SceneReport report = describe_scene(open_world(options.folder, globals));
  std::fputs((options.json ? info_json(report) : info_text(report)).c_str(), stdout);
  return kExitFine;
}

}  // namespace

Command info_command() {
  const auto options = std::make_shared<InfoOptions>();
  Command command{"info", "Tells what a scene is, in numbers, and what looks wrong with it"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "--json", .help = "Print one JSON object", .target = &options->json},
  };
  command.footer =
      "Examples:\n"
      "  prairie info examples/meadow\n"
      "  prairie info examples/meadow --json | jq .expected_blades";
  command.run = [options](const GlobalOptions& globals) { return print_info(*options, globals); };
  return command;
}

}  // namespace prairie
