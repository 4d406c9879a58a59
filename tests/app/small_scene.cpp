#include "tests/app/small_scene.h"

#include <cmath>

#include "tests/maps/test_images.h"

namespace prairie::testing {
namespace {

constexpr int kNodes = 17;  // one per metre

}  // namespace

std::string small_scene_toml() {
  return R"(version = 1
seed = 5
tile_m = 4.0
[height]
file = "ground.tif"
spacing_m = 1.0
[[species]]
name = "grass"
density = { file = "density.png", spacing_m = 1.0, max_per_m2 = 100 }
[[camera]]
name = "default"
position_m = [8.0, 1.0, "+1.7"]
yaw_deg = 0.0
pitch_deg = -10.0
)";
}

void write_small_scene(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<float> height_m;
  for (int row = 0; row < kNodes; ++row) {
    for (int column = 0; column < kNodes; ++column) {
      height_m.push_back(0.5f * std::sin(0.4f * static_cast<float>(column)) +
                         0.05f * static_cast<float>(row));
    }
  }
  write_image(folder / "ground.tif", kNodes, kNodes, 1, OIIO::TypeDesc::FLOAT, height_m);
  std::vector<std::uint8_t> density;
  for (int node = 0; node < kNodes * kNodes; ++node)
    density.push_back(static_cast<std::uint8_t>(255 - node % 50));
  write_image(folder / "density.png", kNodes, kNodes, 1, OIIO::TypeDesc::UINT8, density);
  write_text(folder / "scene.toml", small_scene_toml());
}

}  // namespace prairie::testing
