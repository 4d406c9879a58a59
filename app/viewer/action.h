// What a person can do at the window, as tables that follow one another: the viewer's (app/viewer/actions.h),
// and whatever another folder adds. What keys and buttons do, and all lists of keys, follow from them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/viewer/key.h"
#include "app/viewer/session.h"

namespace prairie {

struct Action {
  std::string name;       // does not change: "send-gust"
  std::string menu;       // among what it belongs: "wind"
  std::vector<Key> keys;  // each of them does it
  std::string label;      // a word or two, on its button and in the window's help; ASCII
  std::string help;       // what it does
  /// Nothing where the keys are held rather than pressed (app/viewer/window.h).
  std::function<void(Session&)> perform = {};
  std::function<bool(const Session&)> is_available = [](const Session&) { return true; };
  bool has_button = false;
};

/// Does what that key stands for now, if anything. Either way, what the last action told has been read.
void press(Key key, std::span<const Action> actions, Session& session);

/// The same with the action of that name.
void perform(std::string_view name, std::span<const Action> actions, Session& session);

}  // namespace prairie
