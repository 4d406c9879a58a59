// Lists of places, [[x, y], …] in metres, in a scene's file.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "world/toml_reader.h"

namespace prairie {

struct PointCounts {
  std::size_t least = 1, most = 1000;
};

/// The required key `key`. Throws BadInput.
std::vector<glm::dvec2> read_points(TableReader& table, std::string_view key, PointCounts counts);

/// An array of such lists; empty where the key is absent.
std::vector<std::vector<glm::dvec2>> read_point_lists(TableReader& table, std::string_view key,
                                                      PointCounts counts);

/// The required key `key`: [x, y] within what scenes may span.
glm::dvec2 need_place(TableReader& table, std::string_view key);

}  // namespace prairie
