// What looks wrong but may be meant: a line for people, and a code by which programs tell one kind from
// another (docs/manual.md lists them).
#pragma once

#include <string>

namespace prairie {

struct Warning {
  std::string code;  // "no-data", "clamped", …
  std::string text;  // "FILE: FIELD: what, where, and what to do"

  bool operator==(const Warning&) const = default;
};

}  // namespace prairie
