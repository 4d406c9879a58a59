#include "app/viewer/key_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "files/joined.h"

namespace prairie {
namespace {

constexpr std::size_t kMenuColumns = 9, kMostColumns = 90;  // of the short help

std::string key_names(const Action& action, const char* between) {
  std::vector<std::string> names;
  for (const Key key : action.keys) names.push_back(key_name(key));
  return joined(names, between);
}

/// What stands in a line of the short help, such as "[ ]: speed".
struct Entry {
  std::string menu;
  std::string keys;
  std::string label;
};

std::vector<Entry> entries(std::span<const Action> actions, const Session& session) {
  std::vector<Entry> all;
  for (const Action& action : actions) {
    if (action.keys.empty() || !action.is_available(session)) continue;
    // What is held takes several keys; what is pressed takes any of them.
    const std::string keys = action.perform ? key_name(action.keys.front()) : key_names(action, " ");
    if (!all.empty() && all.back().menu == action.menu && all.back().label == action.label)
      all.back().keys += ' ' + keys;
    else
      all.push_back({action.menu, keys, action.label});
  }
  return all;
}

}  // namespace

std::vector<KeyHelp> key_help(std::span<const Action> actions) {
  std::vector<KeyHelp> all;
  for (const Action& action : actions) {
    if (action.keys.empty()) continue;
    const std::string keys = key_names(action, ", ");
    if (!all.empty() && all.back().keys == keys)
      all.back().help += "; " + action.help;
    else
      all.push_back({keys, action.help});
  }
  return all;
}

std::string key_table(std::span<const Action> actions) {
  const std::vector<KeyHelp> all = key_help(actions);
  std::size_t columns = 0;
  for (const KeyHelp& line : all) columns = std::max(columns, line.keys.size());
  std::string table;
  for (const KeyHelp& line : all) table += fmt::format("  {:<{}}  {}\n", line.keys, columns, line.help);
  return table;
}

std::string short_key_help(std::span<const Action> actions, const Session& session) {
  std::string text, line, menu;
  for (const Entry& entry : entries(actions, session)) {
    const std::string words = fmt::format("{}: {}", entry.keys, entry.label);
    const bool begins_menu = entry.menu != menu;
    if (begins_menu || line.size() + 3 + words.size() > kMostColumns) {
      if (!line.empty()) text += line + '\n';
      line = fmt::format("{:<{}}{}", begins_menu ? entry.menu : "", kMenuColumns, words);
      menu = entry.menu;
    } else {
      line += "   " + words;
    }
  }
  return text + line;
}

}  // namespace prairie
