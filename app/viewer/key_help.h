// What the keys do, as text: in the window, on the command line, in the manual. All of it follows from the
// actions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/viewer/action.h"

namespace prairie {

struct KeyHelp {
  std::string keys;  // "W, A, S, D"
  std::string help;

  bool operator==(const KeyHelp&) const = default;
};

/// Of all actions, in their order; neighbours that share their keys share a line, too.
std::vector<KeyHelp> key_help(std::span<const Action> actions);

/// The same in two columns, a line each.
std::string key_table(std::span<const Action> actions);

/// What is available now, in short: lines for each menu, with what the keys change where several change one
/// thing.
std::string short_key_help(std::span<const Action> actions, const Session& session);

}  // namespace prairie
