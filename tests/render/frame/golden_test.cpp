// Pictures against those that a person has looked at: tests/render/golden/*.png, made with Mesa 22.3
// llvmpipe.
//
// The same driver gives the same pixels; another version of it, or a GPU, draws some edge pixels otherwise. A
// share of the pixels may therefore differ by more than a step that an eye would see (8 of 255), and the rest
// by no more; each case says how large a share, by how many of its pixels are edges of blades.
//
// After a change of the look that is meant: PRAIRIE_UPDATE_GOLDEN=1 in the environment writes the pictures
// into the source tree; look at them before committing.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <vector>

#include "pictures/picture_encoding.h"
#include "pictures/picture_input.h"
#include "render/frame/pass.h"
#include "render/frame/renderer.h"
#include "render/things/walker_pass.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"
#include "tests/render/things/walking.h"

namespace prairie {
namespace {

constexpr int kVisibleStep = 8;
const std::filesystem::path kGoldenFolder =
    std::filesystem::path(PRAIRIE_SOURCES) / "tests/render/frame/golden";

std::filesystem::path golden_file(const std::string& name) {
  return kGoldenFolder / (name + ".png");
}

class GoldenTest : public HeadlessTest {
 protected:
  void compare(const std::string& name, const Picture& picture, double differing_share) {
    if (std::getenv("PRAIRIE_UPDATE_GOLDEN") != nullptr) {
      const std::vector<std::byte> png = encode_png_rgb8(picture.width, picture.height, picture.srgb);
      std::filesystem::create_directories(kGoldenFolder);
      std::ofstream(golden_file(name), std::ios::binary)
          .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
      GTEST_SKIP() << "wrote " << golden_file(name);
    }
    const Picture expected = read_picture(golden_file(name), "golden picture");
    const std::vector<std::uint8_t>& golden = expected.srgb;
    ASSERT_EQ(expected.width, picture.width);
    ASSERT_EQ(expected.height, picture.height);
    std::size_t differing = 0;
    for (std::size_t n = 0; n < golden.size(); n += 3) {
      int most = 0;
      for (std::size_t channel = n; channel < n + 3; ++channel) {
        most = std::max(
            most, std::abs(static_cast<int>(golden[channel]) - static_cast<int>(picture.srgb[channel])));
      }
      differing += most > kVisibleStep;
    }
    const double share = 3.0 * static_cast<double>(differing) / static_cast<double>(golden.size());
    std::printf("%s: %.3f %% of the pixels differ visibly\n", name.c_str(), 100.0 * share);
    if (share > differing_share) keep(name, picture);
    EXPECT_LE(share, differing_share) << "the picture is kept in " << kept_file(name);
  }

  TemporaryFolder folder_;

 private:
  static std::filesystem::path kept_file(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("prairie-" + name + ".png");
  }
  static void keep(const std::string& name, const Picture& picture) {
    const std::vector<std::byte> png = encode_png_rgb8(picture.width, picture.height, picture.srgb);
    std::ofstream(kept_file(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  }
};

/// A person's view: a third of it sky and far ground, the rest blades of a few pixels.
TEST_F(GoldenTest, Default) {
  const World world = open_world(meadow_scene(folder_));
  compare(
      "default",
      Renderer(world, PRAIRIE_TEST_SHADERS).render(camera_above(world, {16.0, 1.0}, 1.7, 0.0, -0.15), {}, 4),
      0.05);
}

/// A hand's breadth above the ground: wide blades, few edges.
TEST_F(GoldenTest, Close) {
  const World world = open_world(meadow_scene(folder_));
  compare(
      "close",
      Renderer(world, PRAIRIE_TEST_SHADERS).render(camera_above(world, {9.0, 12.0}, 0.5, 0.8, -0.35), {}, 4),
      0.05);
}

/// From above, in a parallel projection, with the bare round in the picture: nearly every pixel holds an
/// edge.
TEST_F(GoldenTest, Top) {
  const World world = open_world(meadow_scene(folder_));
  Camera camera = camera_above(world, {22.0, 16.0}, 20.0, 0.0, -1.5707963);
  camera.orthographic_height_m = 12.0;
  compare("top", Renderer(world, PRAIRIE_TEST_SHADERS).render(camera, {}, 4), 0.08);
}

/// Walkers near and far among the grass, from the front, the side and behind.
TEST_F(GoldenTest, Walkers) {
  const World world = open_world(meadow_scene(folder_));
  const HeightField& ground = world.meadow().ground;
  std::vector<WalkerLook> walkers = {walking(ground, {15.2, 4.4}, -1.4, 1.18, 4.3, 1.75, 3),
                                     walking(ground, {16.5, 4.9}, 0.2, 1.5, 4.0, 1.68, 5),
                                     walking(ground, {17.4, 6.5}, 1.5, 0.0, 0.5, 1.82, 8)};
  for (std::uint32_t n = 0; n < 8; ++n)
    walkers.push_back(
        walking(ground, {11.0 + 1.4 * n, 14.0 + 3.0 * (n % 3)}, 0.8 * n, 1.0, 3.0 + 0.1 * n, 1.7, n));
  Camera camera = camera_above(world, {16.0, 1.0}, 1.7, 0.0, -0.15);
  camera.size_px = {320, 240};
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  WalkerPass pass(PRAIRIE_TEST_SHADERS);
  const auto walkers_pass = std::ranges::find(renderer.passes(), std::string_view("walkers"), &Pass::name);
  renderer.passes().insert(walkers_pass, {.name = "posed walkers",
                                          .state = WalkerPass::kState,
                                          .prepare =
                                              [&](const ViewInputs& in) {
                                                return pass.prepare(in.stream, walkers, in.plan.camera,
                                                                    in.sward_height_m);
                                              },
                                          .draw = [&](const ViewInputs&) { pass.draw(); }});
  compare("walkers", renderer.render(camera, {}, 4), 0.05);
}

/// A trunk, a block, rocks and a wall on a slope in the grass. A quarter of the picture is theirs, smooth but
/// for the relief on them; the rest is blades as in the other cases.
TEST_F(GoldenTest, Obstacles) {
  Scene scene = meadow_scene(folder_);
  StandingThings& things = scene.standing;
  things.obstacles = {Trunk{{13.6, 6.6}, 0.22, 1.9}, Block{{14.8, 6.2}, {1.4, 0.8, 0.9}, 0.5},
                      Rock{{16.7, 5.8}, {1.4, 1.0, 1.1}, 0.4, 3}, Rock{{16.0, 4.6}, {0.5, 0.4, 0.4}, 1.0, 9}};
  Wall wall;
  wall.outline.outer_m = {{11.0, 8.2}, {16.0, 8.9}, {20.0, 7.2}, {20.2, 7.5}, {16.1, 9.2}, {10.9, 8.5}};
  wall.walkers = WallSide::kOutside;
  wall.height_m = 0.9;
  things.walls = {wall};
  const World world = open_world(scene);
  Camera camera = camera_above(world, {15.5, 1.2}, 1.7, 0.0, -0.2);
  camera.size_px = {320, 240};
  compare("obstacles", Renderer(world, PRAIRIE_TEST_SHADERS).render(camera, {}, 4), 0.05);
}

}  // namespace
}  // namespace prairie
