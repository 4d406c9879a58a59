#include "app/commands/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "app/terminal/exit_code.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

void add_global_options(CLI::App& app, GlobalOptions& globals, bool& list_devices) {
  const auto add = [&app](const std::string& name, const std::string& type,
                          std::function<void(const std::string&)> set, const std::string& help) {
    app.add_option_function<std::string>(name, set, help)->type_name(type);
  };
  add(
      "--seed", "N", [&](const std::string& text) { globals.seed = seed_option("--seed", text); },
      "Plant with this seed instead of the scene's");
  add(
      "--threads", "N",
      [&](const std::string& text) { globals.threads = int_option("--threads", text, 1, kMaxThreads); },
      "Use at most so many threads (all cores)");
  add(
      "--device", "DEVICE", [&](const std::string& text) { globals.device = text; },
      "Draw on this device: a number or a part of a name that --list-devices shows");
  app.add_flag("--list-devices", list_devices, "List the devices that can draw without a window");
  add(
      "--max-memory", "BYTES",
      [&](const std::string& text) { globals.max_memory_bytes = bytes_option("--max-memory", text); },
      "Refuse what needs more, such as 512M or 4G (2G)");
  app.add_option("--set", globals.overrides,
                 "Override a key of scene.toml, such as sun.elevation_deg=20; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_flag("-q,--quiet", globals.quiet, "Say nothing but errors");
}

int print_devices() {
  for (const std::string& device : list_devices()) fmt::print("{}\n", device);
  return kExitFine;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The word that nobody knows: a mistyped command, a mistyped option, or one argument too many.
UsageError unknown_word(const CLI::App& app, const std::string& word) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (word.starts_with('-')) {
    std::vector<std::string> names = option_names(app);
    for (const CLI::App* command : parsed) {
      const std::vector<std::string> own = option_names(*command);
      names.insert(names.end(), own.begin(), own.end());
    }
    const std::string option = word.substr(0, word.find('='));
    return {"", option + did_you_mean(option, names), "an option that --help shows"};
  }
  if (!parsed.empty()) return {parsed.front()->get_name(), word, "no further argument"};
  const std::vector<std::string> names = command_names(app);
  return {"", word + did_you_mean(word, names), fmt::format("one of {}", fmt::join(names, ", "))};
}

/// What CLI11 finds wrong with known options, in the words of the other errors.
UsageError misused(const std::string& command, const CLI::ParseError& error) {
  const std::string complaint = error.what();
  const std::string_view required = " is required";
  if (complaint.ends_with(required)) {
    return {command, "no " + complaint.substr(0, complaint.size() - required.size()), "one"};
  }
  return {command, complaint, "what --help shows"};
}

}  // namespace

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Grows and renders grassland from density maps", "prairie")) {
  app_->fallthrough();  // the global options may follow the command's name
  app_->require_subcommand(0, 1);
  app_->set_version_flag("--version", std::string("prairie ") + PRAIRIE_VERSION);
  app_->footer(
      "Examples:\n"
      "  prairie new meadow\n"
      "  prairie render meadow -o meadow.png\n"
      "  prairie record meadow -o meadow.mp4\n"
      "  prairie view meadow\n"
      "Exit codes: 0 fine, 1 failure, 2 command line, 3 bad input, 4 no suitable OpenGL, 130 interrupted.\n"
      "'prairie COMMAND --help' tells more.");
  add_global_options(*app_, globals, list_devices_);
  for (const auto add_command :
       {add_new_command, add_info_command, add_render_command, add_record_command, add_export_command,
        add_plant_command, add_view_command, add_walk_command, add_bench_command}) {
    add_command(*app_, globals, chosen);
  }
  for (CLI::App* command : app_->get_subcommands({})) {
    command->footer(command->get_footer() +
                    "\nOptions of every command (--seed, --set, --quiet, …): prairie --help");
  }
}

void CommandLine::read(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help or --version
    chosen = [this, asked] { return app_->exit(asked); };
    return;
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app_->remaining(true);
    if (!unknown.empty()) throw unknown_word(*app_, unknown.front());
    const std::vector<CLI::App*> parsed = app_->get_subcommands();
    throw misused(parsed.empty() ? "" : parsed.front()->get_name(), error);
  }
  if (list_devices_) chosen = print_devices;
  if (!chosen) {
    throw UsageError("", "no command", fmt::format("one of {}", fmt::join(command_names(*app_), ", ")));
  }
}

}  // namespace prairie
