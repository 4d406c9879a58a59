// What is told of a key in a scene's file, apart from what it fills.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world/scene/key_unit.h"
#include "world/scene/point_list.h"
#include "world/scene/toml_reader.h"

namespace prairie {

/// A line of the text that is hashed (world/scene/canonical_text.h): lower ranks come first, equal ones in
/// the table's order. Without a name the value is not hashed.
struct HashLine {
  std::string_view name = {};
  int rank = 0;
};

struct KeyTraits {
  std::string_view name = {};        // empty: hashed, but nothing that a scene's file may set
  std::optional<Bounds> range = {};  // in the key's unit; none: a room below checks it
  Unit unit = Unit::kMembers;
  PointCounts counts = {};              // of lists of points
  std::vector<std::string> words = {};  // of one of some words, in the order of the member's enumerators
  bool is_required = false;
  HashLine hash = {};
};

}  // namespace prairie
