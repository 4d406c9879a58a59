// `prairie info`: the command line of app/scenes/info.h.
#include <iostream>
#include <memory>

#include "app/commands/commands.h"
#include "app/scenes/info.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"

namespace prairie {
namespace {

struct InfoOptions {
  std::filesystem::path folder;
  bool json = false;
};

int print_info(const InfoOptions& options, GlobalOptions globals) {
  globals.quiet = true;  // the report itself holds the warnings
  const SceneReport report = describe_scene(open_world(options.folder, globals));
  options.json ? print_json(report, std::cout) : print_text(report, std::cout);
  return kExitFine;
}

}  // namespace

void add_info_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("info", "Tells what a scene is, in numbers, and what looks wrong with it");
  auto options = std::make_shared<InfoOptions>();
  command->add_option("DIR", options->folder, "The scene's folder")->required()->type_name("");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "Examples:\n"
      "  prairie info examples/meadow\n"
      "  prairie info examples/meadow --json | jq .expected_blades");
  command->callback([options, &globals, &chosen] {
    chosen = [options, &globals] { return print_info(*options, globals); };
  });
}

}  // namespace prairie
