// What the viewer's panels say.
#include "app/viewer/panel_texts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

Camera start() {
  Camera camera;
  camera.eye_m = {25.0, 20.0, 9.0};
  camera.size_px = {320, 200};
  return camera;
}

TEST(PanelTexts, TellWhatFramesDraw) {
  World world = testing::walking_world();
  Session session(world, start(), {});
  session.frame_options.tier_tint = true;
  DrawnFrame frame;
  frame.median_ms = 16.66;
  frame.statistics.spline = {1234, 5678};
  frame.statistics.plan_ms = 1.5;
  std::vector<std::string> lines = statistics_lines(session, frame);
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0], "  16.7 ms   plan 1.50 ms   320 x 200   tier auto, tinted");
  EXPECT_EQ(lines[2], "spline           1,234         5,678");
  frame.statistics.gpu_times = {{"blades", 2.0}, {"sky", 0.5}};
  lines = statistics_lines(session, frame);
  EXPECT_EQ(lines.back(), "GPU   blades 2.00 ms   sky 0.50 ms");
}

TEST(PanelTexts, TellOfTheCameraAndTime) {
  World world = testing::walking_world();
  ViewerOptions options;
  options.paused = true;
  Session session(world, start(), options);
  EXPECT_EQ(camera_line(session), "flying   25.00,20.00,9.00,0.0,0.0");
  EXPECT_EQ(time_line(session), "0.00 s, paused   step 0.0 ms   0 blades touched");
  session.play.toggle_pause();
  EXPECT_EQ(time_line(session), "0.00 s   step 0.0 ms   0 blades touched");
  session.camera.change_mode(world);
  EXPECT_TRUE(camera_line(session).starts_with("follow   ")) << camera_line(session);
}

TEST(PanelTexts, TellOfWalkersWhereThereAreSome) {
  World nobody(testing::walking_scene(""), {});
  EXPECT_TRUE(walker_lines(Session(nobody, start(), {}), {}).empty());
  World world = testing::walking_world();
  Session session(world, start(), {});
  EXPECT_EQ(walker_lines(session, {}), std::vector<std::string>{"3 walkers"});
  session.walker_overlay = WalkerOverlay::kPaths;
  session.watch_next_walker();
  const ShownWalkers walkers = session.shown_walkers();
  DrawnFrame frame;
  frame.percepts = walkers.percepts;
  const std::vector<std::string> lines = walker_lines(session, frame);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "3 walkers   paths");
  EXPECT_TRUE(lines[1].starts_with("walker ")) << lines[1];
}

TEST(PanelTexts, NameTheFieldThatIsShown) {
  World world = testing::walking_world();
  Session session(world, start(), {});
  EXPECT_EQ(field_line(session), "");
  session.frame_options.field_overlay = FieldOverlay::kTilt;
  EXPECT_EQ(field_line(session), "field: trodden grass");
}

}  // namespace
}  // namespace prairie
