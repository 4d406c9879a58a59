// The keys that the viewer's actions name, whatever library tells of them. Knows nothing of windows.
#pragma once

#include <string>
#include <variant>

namespace prairie {

/// What prints nothing, or what another key prints, too. What the mouse does stands among the keys, so that
/// one table holds all that a person can do.
enum class NamedKey {
  kOther,  // which no action has
  kEscape,
  kEnter,
  kTab,
  kBackspace,
  kInsert,
  kDelete,
  kHome,
  kEnd,
  kPageUp,
  kPageDown,
  kF1,
  kF2,
  kF3,
  kF4,
  kF5,
  kF6,
  kF7,
  kF8,
  kF9,
  kF10,
  kF11,
  kF12,
  kKeypadAdd,
  kKeypadSubtract,
  kShift,   // either
  kArrows,  // any of the four
  kMouseDrag,
  kMouseWheel
};

/// A printable key is the character on it on a US keyboard, as a capital.
using Key = std::variant<char, NamedKey>;

/// As a person reads it: "P", "[", "Esc", "key pad +".
std::string key_name(Key key);

}  // namespace prairie
