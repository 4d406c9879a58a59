#include "app/viewer/key.h"

#include <array>
#include <cstddef>

namespace prairie {
namespace {

/// In the order of NamedKey.
constexpr std::array kNames{
    "another key", "Esc", "Enter", "Tab",       "Backspace", "Insert", "Delete", "Home", "End",  "Page Up",
    "Page Down",   "F1",  "F2",    "F3",        "F4",        "F5",     "F6",     "F7",   "F8",   "F9",
    "F10",         "F11", "F12",   "key pad +", "key pad -", "shift",  "arrows", "drag", "wheel"};
static_assert(kNames.size() == static_cast<std::size_t>(NamedKey::kMouseWheel) + 1);

}  // namespace

std::string key_name(Key key) {
  if (const NamedKey* named = std::get_if<NamedKey>(&key)) return kNames[static_cast<std::size_t>(*named)];
  const char character = std::get<char>(key);
  return character == ' ' ? "space" : std::string(1, character);
}

}  // namespace prairie
