// Scene folders for tests: small maps and the scene files around them.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "files/error.h"
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

/// A scene that is refused.
struct Refusal {
  std::string text;  // after the plain scene
  const char* field;
  const char* in_message;
};

void PrintTo(const Refusal& refusal, std::ostream* out);

/// Expects the fault to be told in one line that names the file, the field and what is wrong with it.
void expect_refused(const Refusal& refusal);

/// A float GeoTIFF of `columns` × `rows` nodes with value(column, row), row 0 south; NaN becomes nodata.
void write_raster(const std::filesystem::path& path, int columns, int rows, double spacing_m,
                  const std::optional<glm::dvec2>& south_west_m,
                  const std::function<float(int column, int row)>& value);

World open_scene(const std::filesystem::path& folder, const std::string& text);

}  // namespace prairie::testing
