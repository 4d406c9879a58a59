#include "app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/commands.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "files/joined.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

std::vector<CommandOption> global_options(GlobalOptions& globals, bool& lists_devices) {
  return {
      {.names = "--seed",
       .type = "N",
       .help = "Plant with this seed instead of the scene's",
       .target = parsed_into(globals.seed, seed_option)},
      {.names = "--threads",
       .type = "N",
       .help = "Use at most so many threads (all cores)",
       .target = whole_number_into(globals.threads, 1, kMaxThreads)},
      {.names = "--device",
       .type = "DEVICE",
       .help = "Draw on this device: a number or a part of a name that --list-devices shows",
       .target = text_into(globals.device)},
      {.names = "--list-devices",
       .help = "List the devices that can draw without a window",
       .target = &lists_devices},
      {.names = "--max-memory",
       .type = "BYTES",
       .help = "Refuse what needs more, such as 512M or 4G (2G)",
       .target = parsed_into(globals.max_memory_bytes, bytes_option)},
      {.names = "--set",
       .type = "KEY=VALUE",
       .help = "Override a key of scene.toml, such as sun.elevation_deg=20; repeatable",
       .target = &globals.overrides},
      {.names = "-q,--quiet", .help = "Say nothing but errors", .target = &globals.quiet},
  };
}

int print_devices(const GlobalOptions&) {
  for (const std::string& device : list_devices()) fmt::print("{}\n", device);
  return kExitFine;
}

CLI::Option* add_option(CLI::App& app, const CommandOption& option) {
  if (bool* const* flag = std::get_if<bool*>(&option.target))
    return app.add_flag(option.names, **flag, option.help);
  if (std::vector<std::string>* const* texts = std::get_if<std::vector<std::string>*>(&option.target)) {
    return app.add_option(option.names, **texts, option.help)
        ->type_name(option.type)
        ->allow_extra_args(false);
  }
  const std::string_view names = option.names;
  const std::string last_name(names.substr(names.rfind(',') + 1));
  const auto take = [last_name, target = std::get<TextTarget>(option.target)](const std::string& text) {
    target(last_name, text);
  };
  return app.add_option_function<std::string>(option.names, take, option.help)->type_name(option.type);
}

void add_options(CLI::App& app, const std::vector<CommandOption>& options) {
  for (const CommandOption& option : options) {
    CLI::Option* added = add_option(app, option);
    added->required(option.is_required);
    if (option.is_hidden) added->group("");
    if (option.needs) added->needs(app.get_option(option.needs));
    if (option.excludes) added->excludes(app.get_option(option.excludes));
  }
}

void add_command(CLI::App& app, const Command& command) {
  CLI::App* added = app.add_subcommand(command.name, command.summary);
  add_options(*added, command.options);
  added->footer(command.footer + "\nOptions of every command (--seed, --set, --quiet, …): prairie --help");
}

void describe_program(CLI::App& app) {
  app.fallthrough();  // the global options may follow the command's name
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", std::string("prairie ") + PRAIRIE_VERSION);
  app.footer(
      "Examples:\n"
      "  prairie new meadow\n"
      "  prairie render meadow -o meadow.png\n"
      "  prairie record meadow -o meadow.mp4\n"
      "  prairie view meadow\n"
      "Exit codes: 0 fine, 1 failure, 2 command line, 3 bad input, 4 no suitable OpenGL, 130 interrupted.\n"
      "'prairie COMMAND --help' tells more.");
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
  return {"", word + did_you_mean(word, names), "one of " + joined(names, ", ")};
}

/// What CLI11 finds wrong with known options, in the words of the other errors.
UsageError misused(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const std::string command = parsed.empty() ? "" : parsed.front()->get_name();
  const std::string complaint = error.what();
  const std::string_view required = " is required";
  if (complaint.ends_with(required)) {
    return {command, "no " + complaint.substr(0, complaint.size() - required.size()), "one"};
  }
  return {command, complaint, "what --help shows"};
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
  CommandLine line;
  bool lists_devices = false;
  const std::vector<Command> commands = all_commands();
  CLI::App app("Grows and renders grassland from density maps", "prairie");
  describe_program(app);
  add_options(app, global_options(line.globals, lists_devices));
  for (const Command& command : commands) add_command(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help or --version
    std::ostringstream text;
    app.exit(asked, text);
    line.run = [text = text.str()](const GlobalOptions&) {
      std::fputs(text.c_str(), stdout);
      return kExitFine;
    };
    return line;
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app.remaining(true);
    throw unknown.empty() ? misused(app, error) : unknown_word(app, unknown.front());
  }
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (lists_devices) {
    line.run = print_devices;
  } else if (!parsed.empty()) {
    line.run = std::ranges::find(commands, parsed.front()->get_name(), &Command::name)->run;
  } else {
    throw UsageError("", "no command", "one of " + joined(command_names(app), ", "));
  }
  return line;
}

}  // namespace prairie
