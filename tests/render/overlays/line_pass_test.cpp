// Lines over the picture: they are where they should be and as wide, what comes from behind the eye is cut
// off, and nothing but colours changes.
#include "render/overlays/line_pass.h"

#include <algorithm>
#include <vector>

#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

constexpr glm::vec4 kRed(0.9f, 0.0f, 0.0f, 1.0f);

class LinePassTest : public HeadlessTest {
 protected:
  /// Which pixels differ between a picture with and one without the lines.
  std::vector<bool> changed(Renderer& renderer, const Camera& camera, std::span<const LineSegment> lines,
                            bool msaa = false) {
    FrameOptions options;
    options.msaa = msaa;
    const Picture plain = renderer.render(camera, options, 1);
    options.lines = lines;
    const Picture shown = renderer.render(camera, options, 1);
    EXPECT_EQ(shown.cover, plain.cover);
    std::vector<bool> changed;
    for (std::size_t n = 0; n < plain.cover.size(); ++n) {
      changed.push_back(!std::equal(&shown.srgb[3 * n], &shown.srgb[3 * n] + 3, &plain.srgb[3 * n]));
    }
    options.lines = {};
    EXPECT_EQ(renderer.render(camera, options, 1).srgb, plain.srgb) << "lines leave nothing behind";
    return changed;
  }

  const TemporaryFolder folder_;
  World world_ = open_world(meadow_scene(folder_));
};

TEST_F(LinePassTest, ALevelLineCrossesThePicture) {
  Renderer renderer(world_, PRAIRIE_TEST_SHADERS);
  Camera camera = camera_above(world_, {16.0, 4.0}, 2.0, 0.0, 0.2);
  camera.size_px = {160, 120};
  const glm::dvec3 middle_m = camera.eye_m + 5.0 * camera.forward();
  for (const bool msaa : {false, true}) {
    const LineSegment line{middle_m - 20.0 * camera.right(), middle_m + 20.0 * camera.right(), kRed};
    const std::vector<bool> pixels = changed(renderer, camera, {&line, 1}, msaa);
    for (int column = 0; column < 160; ++column) {
      int found = 0;
      for (int row = 0; row < 120; ++row) {
        const bool is_changed =
            pixels[static_cast<std::size_t>(row) * 160 + static_cast<std::size_t>(column)];
        if (!is_changed) continue;
        EXPECT_NEAR(row, 59.5, 1.6);
        ++found;
      }
      EXPECT_GE(found, 1) << column;
      EXPECT_LE(found, 3) << column;
    }
  }
}

TEST_F(LinePassTest, WhatIsBehindTheEyeIsCutOff) {
  Renderer renderer(world_, PRAIRIE_TEST_SHADERS);
  Camera camera = camera_above(world_, {16.0, 4.0}, 2.0, 0.0, 0.1);
  camera.size_px = {160, 120};
  // From below behind the eye to straight ahead: it comes up from the lower edge and ends in the middle.
  const glm::dvec3 ahead_m = camera.eye_m + 5.0 * camera.forward();
  const LineSegment along{camera.eye_m - 5.0 * camera.forward() - 0.5 * camera.up(), ahead_m, kRed};
  const std::vector<bool> pixels = changed(renderer, camera, {&along, 1});
  for (int row = 0; row < 120; ++row) {
    const auto first = pixels.begin() + row * 160;
    const auto found = std::count(first, first + 160, true);
    EXPECT_EQ(std::count(first, first + 76, true) + std::count(first + 84, first + 160, true), 0) << row;
    if (row >= 58 && row <= 61) continue;  // the line's end
    EXPECT_EQ(found > 0, row > 61) << row;
  }
  const LineSegment behind{camera.eye_m - camera.forward(), camera.eye_m - 9.0 * camera.forward(), kRed};
  const std::vector<bool> none = changed(renderer, camera, {&behind, 1});
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

TEST_F(LinePassTest, PointsAndParallelProjectionsAreFine) {
  Renderer renderer(world_, PRAIRIE_TEST_SHADERS);
  Camera camera = camera_above(world_, {16.0, 16.0}, 50.0, 0.0, -1.5);
  camera.orthographic_height_m = 20.0;
  camera.size_px = {160, 120};
  const glm::dvec3 middle_m = camera.eye_m + 20.0 * camera.forward();
  const std::vector<LineSegment> lines{
      {middle_m, middle_m, kRed}, {middle_m - 5.0 * camera.right(), middle_m + 5.0 * camera.right(), kRed}};
  const std::vector<bool> pixels = changed(renderer, camera, lines);
  // 10 m of 20 m over 120 pixels.
  const auto found = std::count(pixels.begin(), pixels.end(), true);
  EXPECT_GE(found, 60);
  EXPECT_LE(found, 3 * 64);
}

}  // namespace
}  // namespace prairie
