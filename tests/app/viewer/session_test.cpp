// A session of the viewer, without a window.
#include "app/viewer/session.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::walking_world;

Camera start() {
  Camera camera;
  camera.eye_m = {25.0, 20.0, 2.0};
  return camera;
}

TEST(Session, BeginsAsItsOptionsSay) {
  World world = walking_world();
  ViewerOptions options;
  options.tier = Tier::kStrip;
  options.msaa = true;
  options.paused = true;
  options.follow = 1;
  options.walker_overlay = true;
  options.memory_budget_bytes = 12345;
  const Session session(world, start(), options);
  EXPECT_EQ(session.frame_options.tier, Tier::kStrip);
  EXPECT_TRUE(session.frame_options.msaa);
  EXPECT_EQ(session.frame_options.quality, world.scene().lod.quality);
  EXPECT_EQ(session.frame_options.memory_budget_bytes, 12345u);
  EXPECT_TRUE(session.play.paused());
  EXPECT_EQ(session.camera.watched(), 1u);
  EXPECT_EQ(session.walker_overlay, WalkerOverlay::kBoth);
}

TEST(Session, ASlowFrameDoesNotThrowTheCamera) {
  World world = walking_world();
  Session session(world, start(), {});
  Steering ahead;
  ahead.forward = 1.0;
  session.move_camera(ahead, 100.0, {320, 200});
  EXPECT_EQ(session.camera.camera().size_px, glm::ivec2(320, 200));
  EXPECT_LT(glm::distance(session.camera.camera().eye_m, start().eye_m), 2.0);
}

TEST(Session, ArrowsAreTheSteeredWalkersOrElseTheCarts) {
  World world = walking_world();
  Session session(world, start(), {});
  session.play.take_cart(session.camera.camera());
  session.watch_next_walker();
  session.steering.toggle(session.camera.watched());
  const CartControls up{1.0, 0.0};
  for (int n = 0; n < 20; ++n) session.advance(0.1, up, false);
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_EQ(world.driven()[0].rolled_m, 0.0) << "the cart has no keys meanwhile";
  session.steering.release();
  for (int n = 0; n < 20; ++n) session.advance(0.1, up, false);
  EXPECT_GT(world.driven()[0].rolled_m, 0.5);
}

TEST(Session, WhoeverIsNotWatchedAnyMoreIsGivenBack) {
  World world = walking_world();
  Session session(world, start(), {});
  session.watch_next_walker();
  session.steering.toggle(session.camera.watched());
  ASSERT_TRUE(session.steering.steered());
  session.watch_next_walker();
  EXPECT_FALSE(session.steering.steered());
}

TEST(Session, ShowsOfWalkersWhatIsAskedFor) {
  World world = walking_world();
  Session session(world, start(), {});
  EXPECT_TRUE(session.shown_walkers().percepts.empty());
  session.watch_next_walker();
  EXPECT_EQ(session.shown_walkers().percepts.size(), 3u) << "told of the watched one";
  EXPECT_TRUE(session.shown_walkers().lines.empty());
  session.panels_shown = false;
  EXPECT_TRUE(session.shown_walkers().percepts.empty());
  session.walker_overlay = WalkerOverlay::kSensors;
  const std::size_t sensors = session.shown_walkers().lines.size();
  EXPECT_GT(sensors, 0u);
  for (int n = 0; n < 20; ++n) session.advance(0.1, {}, false);
  session.walker_overlay = WalkerOverlay::kBoth;
  EXPECT_GT(session.shown_walkers().lines.size(), sensors);
}

}  // namespace
}  // namespace prairie
