// A frame of several views shows what each view shows by itself, and all of them the same moment.
#include <cstdint>
#include <vector>

#include "render/frame/renderer.h"
#include "render/gl/gl_objects.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

/// A framebuffer in place of a window.
class Canvas {
 public:
  explicit Canvas(glm::ivec2 size_px) : size_px_(size_px) {
    glTextureStorage2D(color_.get(), 1, GL_RGBA8, size_px.x, size_px.y);
    glNamedFramebufferTexture(framebuffer_.get(), GL_COLOR_ATTACHMENT0, color_.get(), 0);
  }
  GLuint target() const { return framebuffer_.get(); }
  std::vector<std::uint8_t> pixels() const {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(4 * size_px_.x * size_px_.y));
    glGetTextureImage(color_.get(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(rgba.size()),
                      rgba.data());
    return rgba;
  }

 private:
  glm::ivec2 size_px_;
  GlTexture color_ = make_texture(GL_TEXTURE_2D, "canvas");
  GlFramebuffer framebuffer_ = make_framebuffer("canvas");
};

class ViewsTest : public HeadlessTest {
 protected:
  /// Wind blows, a stone rolls and has trodden, a block stands.
  World moving_world() {
    Scene scene = meadow_scene(folder_);
    scene.wind.emplace().speed_m_per_s = 4.0;
    MoverSpec stone;
    stone.name = "stone";
    stone.path.radius_m = 0.4;
    stone.path.path_m = {{14.0, 3.0}, {18.0, 9.0}};
    scene.movers = {stone};
    scene.standing.obstacles = {Block{{13.0, 8.0}, {1.4, 0.8, 0.9}, 0.5}};
    World world = open_world(scene);
    world.watch_anew({16.0, 6.0});
    for (int n = 0; n < 60; ++n) world.step(1.0 / 60.0);
    return world;
  }

  /// A person's view, another one's from aside and of another size and tiers, and a map from above.
  std::vector<FrameView> views(const World& world, const std::vector<Canvas>& canvases) {
    std::vector<FrameView> views(3);
    views[0].camera = camera_above(world, {16.0, 1.0}, 1.7, 0.0, -0.15);
    views[0].camera.size_px = {320, 200};
    views[1].camera = camera_above(world, {22.0, 6.0}, 0.8, -1.4, -0.2);
    views[1].camera.size_px = {160, 160};
    views[1].options.tier_tint = true;
    views[1].options.field_overlay = FieldOverlay::kTilt;
    views[2].camera = camera_above(world, {16.0, 8.0}, 20.0, 0.0, -1.5707963);
    views[2].camera.orthographic_height_m = 12.0;
    views[2].camera.size_px = {200, 120};
    for (std::size_t n = 0; n < canvases.size(); ++n) views[n].target = canvases[n].target();
    return views;
  }

  std::vector<Canvas> canvases() {
    std::vector<Canvas> canvases;
    for (const glm::ivec2 size_px : {glm::ivec2(320, 200), glm::ivec2(160, 160), glm::ivec2(200, 120)})
      canvases.emplace_back(size_px);
    return canvases;
  }

  TemporaryFolder folder_;
};

TEST_F(ViewsTest, OfOneFrameAreThoseOfFramesOfTheirOwn) {
  const World world = moving_world();
  const std::vector<Canvas> together = canvases(), alone = canvases();
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const std::vector<FrameStatistics> statistics = renderer.draw(views(world, together));
  const std::vector<FrameView> each = views(world, alone);
  for (std::size_t n = 0; n < each.size(); ++n) {
    const FrameStatistics one = Renderer(world, PRAIRIE_TEST_SHADERS).draw(each[n]);
    EXPECT_EQ(statistics[n].triangles, one.triangles) << n;
    EXPECT_GT(one.triangles, 1000u) << n;
    EXPECT_TRUE(together[n].pixels() == alone[n].pixels()) << "view " << n;
  }
}

/// The play on tiers follows each view's own eye (lod/planner.h), not that of the view drawn before it.
TEST_F(ViewsTest, FollowTheirOwnEyes) {
  const World world = moving_world();
  const std::vector<Canvas> together = canvases(), alone = canvases();
  Renderer both(world, PRAIRIE_TEST_SHADERS), first(world, PRAIRIE_TEST_SHADERS);
  std::vector<FrameView> seen = views(world, together);
  FrameView by_itself = views(world, alone).front();
  for (int frame = 0; frame < 6; ++frame) {
    both.draw(seen);
    first.draw(by_itself);
    EXPECT_TRUE(together[0].pixels() == alone[0].pixels()) << "frame " << frame;
    for (FrameView* view : {&seen[0], &by_itself}) view->camera.eye_m.y += 0.13;
    seen[1].camera.eye_m.x -= 0.4;
  }
}

TEST_F(ViewsTest, AllShowTheMomentBeforeTheStepBesideThem) {
  const World still = moving_world();
  World moving = moving_world();
  const std::vector<Canvas> together = canvases(), alone = canvases();
  Renderer renderer(moving, PRAIRIE_TEST_SHADERS), expected(still, PRAIRIE_TEST_SHADERS);
  renderer.draw(views(moving, together), [&] { moving.step(0.25); });
  expected.draw(views(still, alone));
  for (std::size_t n = 0; n < together.size(); ++n)
    EXPECT_TRUE(together[n].pixels() == alone[n].pixels()) << "view " << n;
}

}  // namespace
}  // namespace prairie
