// Scene folders for tests: small maps and the scene files around them.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "maps/error.h"
#include "maps/map_file.h"
#include "tests/maps/test_images.h"
#include "world/world.h"

namespace prairie::testing {

/// The shortest scene: level ground, one uniform species.
inline constexpr const char* kPlainScene = R"(version = 1
[ground]
size_m = [40, 20]
[[species]]
name = "fescue"
)";

/// Parses `text`, expects it to be refused, and returns the fault. A fault without a field means it was
/// accepted.
Fault refusal_of(const std::string& text, const std::vector<std::string>& overrides = {});

/// A float GeoTIFF of `columns` × `rows` nodes with value(column, row), row 0 south; NaN becomes nodata.
void write_raster(const std::filesystem::path& path, int columns, int rows, double spacing_m,
                  const std::optional<glm::dvec2>& south_west_m,
                  const std::function<float(int column, int row)>& value);

World open_scene(const std::filesystem::path& folder, const std::string& text);

}  // namespace prairie::testing
