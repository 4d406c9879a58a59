#include "tests/world/scene_texts.h"

#include <gtest/gtest.h>

#include "maps/geotiff_output.h"

namespace prairie::testing {

Fault refusal_of(const std::string& text, const std::vector<std::string>& overrides) {
  try {
    parse_scene(text, "folder", overrides);
  } catch (const BadInput& fault) {
    return fault;
  }
  return Fault("", "", "no refusal", "one");
}

void PrintTo(const Refusal& refusal, std::ostream* out) {
  *out << refusal.text;
}

void expect_refused(const Refusal& refusal) {
  const Fault fault = refusal_of(kPlainScene + refusal.text);
  EXPECT_EQ(fault.file, "folder/scene.toml");
  EXPECT_EQ(fault.field, refusal.field);
  const std::string message = fault.what();
  EXPECT_NE(message.find(refusal.in_message), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

void write_raster(const std::filesystem::path& path, int columns, int rows, double spacing_m,
                  const std::optional<glm::dvec2>& south_west_m,
                  const std::function<float(int column, int row)>& value) {
  std::vector<float> nodes;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) nodes.push_back(value(column, row));
  }
  GridFrame frame;
  frame.columns = columns;
  frame.rows = rows;
  frame.spacing_m = spacing_m;
  GeoReference reference;
  reference.pixel_size_m = spacing_m;
  if (south_west_m) {
    reference.west_m = south_west_m->x;
    reference.south_m = south_west_m->y;
  }
  const NodeGrid grid(frame, 1, std::move(nodes));
  write_bytes(path, encode_geotiff(grid, south_west_m ? &reference : nullptr));
}

World open_scene(const std::filesystem::path& folder, const std::string& text) {
  std::filesystem::create_directories(folder);
  write_text(folder / kSceneFileName, text);
  return World(read_scene(folder, {}), {});
}

}  // namespace prairie::testing
