// Pictures of a small world: the same every time, of the right colours, with the blades that they should
// hold.
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "generator/plant.h"
#include "generator/tiles.h"
#include "render/frame/renderer.h"
#include "render/gl/gl_objects.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

class PictureTest : public HeadlessTest {
 protected:
  TemporaryFolder folder_;
};

/// Mean of the sRGB channels over rows [first, last) of the picture.
std::array<double, 3> mean_color(const Picture& picture, int first, int last) {
  std::array<double, 3> sum{};
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        sum[static_cast<std::size_t>(channel)] += static_cast<double>(
            picture.srgb[static_cast<std::size_t>(3 * (y * picture.width + x) + channel)]);
      }
    }
  }
  for (double& value : sum) value /= static_cast<double>((last - first) * picture.width);
  return sum;
}

TEST_F(PictureTest, IsTheSameEveryTime) {
  const World world = open_world(meadow_scene(folder_));
  const Camera camera = camera_above(world, {16.0, 2.0}, 1.7, 0.0, -0.2);
  const Picture first = Renderer(world, PRAIRIE_TEST_SHADERS).render(camera, {}, 2);
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const Picture second = renderer.render(camera, {}, 2);
  EXPECT_EQ(first.linear_rgb, second.linear_rgb);
  // Neither does it depend on what the renderer drew before.
  renderer.render(camera_above(world, {5.0, 30.0}, 3.0, 2.0, -0.5), {Tier::kHermite, false}, 1);
  EXPECT_EQ(renderer.render(camera, {}, 2).linear_rgb, first.linear_rgb);
}

TEST_F(PictureTest, LooksLikeGrassUnderASky) {
  const World world = open_world(meadow_scene(folder_));
  for (const Tier tier : {Tier::kAuto, Tier::kSpline, Tier::kHermite, Tier::kStrip, Tier::kFlat}) {
    const Picture picture = Renderer(world, PRAIRIE_TEST_SHADERS)
                                .render(camera_above(world, {8.0, 1.0}, 1.7, 0.0, -0.1), {tier, false}, 1);
    const std::array<double, 3> grass = mean_color(picture, 80, 120);
    EXPECT_GT(grass[1], grass[0]) << "greener than red";
    EXPECT_GT(grass[1], grass[2]) << "greener than blue";
    EXPECT_TRUE(grass[1] > 40.0 && grass[1] < 220.0) << grass[1];
    const std::array<double, 3> sky = mean_color(picture, 0, 25);
    EXPECT_GT(sky[2], sky[0]) << "bluer than red";
    EXPECT_GT(sky[2], grass[2] + 20.0);
    EXPECT_TRUE(std::all_of(picture.linear_rgb.begin(), picture.linear_rgb.end(),
                            [](float v) { return std::isfinite(v) && v >= 0.0f; }));
  }
}

TEST_F(PictureTest, HermiteTierDrawsEveryBlade) {
  const World world = open_world(meadow_scene(folder_));
  const Meadow& meadow = world.meadow();
  std::uint64_t planted = 0;
  const TileRange tiles = tiles_of(meadow);
  for (int j = 0; j <= tiles.last.j; ++j) {
    for (int i = 0; i <= tiles.last.i; ++i) planted += planted_count(meadow, {i, j});
  }
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  Camera camera = camera_above(world, {16.0, 16.0}, 40.0, 0.0, -1.5707);
  camera.fov_rad = 1.3;
  const auto drawn = [&](Tier tier) {
    renderer.render(camera, {.tier = tier}, 1);
    return renderer.picture_statistics();
  };
  const FrameStatistics all = drawn(Tier::kHermite);
  EXPECT_EQ(all.blades_drawn, planted);
  EXPECT_EQ(all.blades_planted_in_view, planted);
  const FrameStatistics some = drawn(Tier::kAuto);
  EXPECT_LT(some.blades_drawn, planted);
  EXPECT_GT(some.blades_drawn, 0u);
  EXPECT_EQ(drawn(Tier::kFlat).blades_drawn, 0u);
}

/// The tiers stand for one another: seen from above, the mean colour of the flat one is near that of all
/// blades.
TEST_F(PictureTest, FlatTierHasTheColorOfItsBlades) {
  const World world = open_world(meadow_scene(folder_));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  Camera camera = camera_above(world, {8.0, 16.0}, 12.0, 0.0, -0.9);
  const std::array<double, 3> blades =
      mean_color(renderer.render(camera, {Tier::kHermite, false}, 4), 0, 120);
  const std::array<double, 3> flat = mean_color(renderer.render(camera, {Tier::kFlat, false}, 4), 0, 120);
  std::printf("blades %.0f %.0f %.0f, flat %.0f %.0f %.0f\n", blades[0], blades[1], blades[2], flat[0],
              flat[1], flat[2]);
  for (std::size_t channel = 0; channel < 3; ++channel) EXPECT_NEAR(flat[channel], blades[channel], 40.0);
}

TEST_F(PictureTest, SamplesSmoothAndMsaaKeepsThePicture) {
  const World world = open_world(meadow_scene(folder_));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const Camera camera = camera_above(world, {16.0, 2.0}, 1.7, 0.0, -0.2);
  const std::array<double, 3> one = mean_color(renderer.render(camera, {}, 1), 0, 120);
  const std::array<double, 3> many = mean_color(renderer.render(camera, {}, 8), 0, 120);
  const std::array<double, 3> msaa = mean_color(renderer.render(camera, {Tier::kAuto, true}, 1), 0, 120);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(one[channel], many[channel], 4.0);
    EXPECT_NEAR(one[channel], msaa[channel], 4.0);
  }
}

class MeanwhileTest : public PictureTest {
 protected:
  World windy_world() {
    Scene scene = meadow_scene(folder_);
    scene.wind.emplace().speed_m_per_s = 5.0;
    World world = open_world(std::move(scene));
    world.watch_anew({16.0, 2.0});
    return world;
  }
};

TEST_F(MeanwhileTest, PicturesAreThoseOfAWorldThatWaits) {
  World waiting = windy_world(), going_on = windy_world();
  const Camera camera = camera_above(waiting, {16.0, 2.0}, 1.7, 0.0, -0.2);
  Renderer first(waiting, PRAIRIE_TEST_SHADERS), second(going_on, PRAIRIE_TEST_SHADERS);
  std::vector<float> last;
  for (int frame = 0; frame < 6; ++frame) {
    // The last with a single thread.
    std::optional<tbb::global_control> limit;
    if (frame == 5) limit.emplace(tbb::global_control::max_allowed_parallelism, 1);
    const Picture expected = first.render(camera, {}, 1);
    waiting.step(0.1);
    const Picture found = second.render(camera, {}, 1, [&] { going_on.step(0.1); });
    EXPECT_EQ(found.linear_rgb, expected.linear_rgb) << frame;
    EXPECT_EQ(going_on.saved_state(), waiting.saved_state()) << frame;
    EXPECT_NE(found.linear_rgb, last) << "grass that stands still, frame " << frame;
    last = found.linear_rgb;
  }
}

TEST_F(MeanwhileTest, HasEndedWhenTheFrameIsDrawnAndIsDoneOnce) {
  const World world = windy_world();
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const Camera camera = camera_above(world, {16.0, 2.0}, 1.7, 0.0, -0.2);
  const GlTexture color = make_texture(GL_TEXTURE_2D, "window");
  glTextureStorage2D(color.get(), 1, GL_RGBA8, camera.size_px.x, camera.size_px.y);
  const GlFramebuffer target = make_framebuffer("window");
  glNamedFramebufferTexture(target.get(), GL_COLOR_ATTACHMENT0, color.get(), 0);
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    int done = 0;
    renderer.draw({camera, {}, target.get()}, [&] { ++done; });
    EXPECT_EQ(done, 1);
    renderer.render(camera, {}, 3, [&] { ++done; });
    EXPECT_EQ(done, 2);
    EXPECT_THROW(renderer.draw({camera, {}, target.get()}, [] { throw std::runtime_error("no"); }),
                 std::runtime_error);
    EXPECT_THROW(renderer.render(camera, {}, 1, [] { throw std::runtime_error("no"); }), std::runtime_error);
  }
}

}  // namespace
}  // namespace prairie
