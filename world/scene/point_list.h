// Lists of places, [[x, y], …], and sizes, [ahead, across, up], in metres, in a scene's file.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world/scene/toml_reader.h"

namespace prairie {

struct PointCounts {
  std::size_t least = 1, most = 1000;
};

/// Nothing where the key is absent. Throws BadInput.
std::optional<std::vector<glm::dvec2>> read_points(TableReader& table, std::string_view key,
                                                   PointCounts counts);
[[noreturn]] void refuse_missing_points(const TableReader& table, std::string_view key, PointCounts counts);

/// An array of such lists; empty where the key is absent.
std::vector<std::vector<glm::dvec2>> read_point_lists(TableReader& table, std::string_view key,
                                                      PointCounts counts);

/// [ahead, across, up] in metres, each within the bounds; nothing where the key is absent.
std::optional<glm::dvec3> read_size(TableReader& table, std::string_view key, Bounds bounds);

}  // namespace prairie
