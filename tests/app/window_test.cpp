// Windows that are hidden, resized and brought back, seen from the X server, to which this test talks like a
// window manager. Run under xvfb-run.
#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <thread>
#include <utility>

#include "app/view.h"
#include "lod/camera.h"
#include "tests/app/small_scene.h"
#include "tests/app/window_from_outside.h"
#include "tests/maps/test_images.h"
#include "world/scene.h"
#include "world/world.h"

namespace prairie {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(WindowTest, WaitsWhileItIsHidden) {
  Window window({64, 48});
  ASSERT_TRUE(window.poll());
  ASSERT_TRUE(window.can_be_seen());
  glfwHideWindow(window.handle());
  while (window.can_be_seen()) window.poll();
  while (window.poll()) {  // until no event is left
    const Clock::time_point start = Clock::now();
    window.poll();
    if (Clock::now() - start > 100ms) break;
  }
  const double before_s = cpu_s();
  const Clock::time_point start = Clock::now();
  EXPECT_TRUE(window.poll());
  EXPECT_GT(Clock::now() - start, 100ms) << "did not wait";
  EXPECT_LT(cpu_s() - before_s, 0.05) << "waited busily";
  glfwShowWindow(window.handle());
  for (int n = 0; n < 20 && !window.can_be_seen(); ++n) window.poll();
  EXPECT_TRUE(window.can_be_seen());
  window.close();
  EXPECT_FALSE(window.poll());
}

class ViewerTest : public ::testing::Test {
 protected:
  ViewerTest() { testing::write_small_scene(folder_ / "scene"); }

  /// Shows the scene, while `disturb` does something to the window, which is then closed.
  void view(const std::function<void(testing::WindowFromOutside&)>& disturb) {
    const World world(read_scene(folder_ / "scene", {}), {});
    Camera camera;
    camera.eye_m = {8.0, 1.0, 3.0};
    camera.size_px = {64, 48};
    ViewerOptions options;
    options.memory_budget_bytes = std::uint64_t{1} << 30;
    const std::jthread other([&] {
      testing::WindowFromOutside window;
      ASSERT_TRUE(window.is_there());
      disturb(window);
      window.close();
    });
    view_world(world, camera, options);
  }

  const testing::TemporaryFolder folder_;
};

TEST_F(ViewerTest, DrawsNothingWhileItIsHidden) {
  double hidden_cpu_s = 0.0;
  bool shown_again = false;
  view([&](testing::WindowFromOutside& window) {
    window.hide();
    std::this_thread::sleep_for(200ms);  // the frame that was being drawn
    const double before_s = cpu_s();
    std::this_thread::sleep_for(2s);
    hidden_cpu_s = cpu_s() - before_s;
    shown_again = true;
    window.show();
  });
  EXPECT_TRUE(shown_again);
  EXPECT_LT(hidden_cpu_s, 0.4);
}

TEST_F(ViewerTest, FollowsTheWindowsSize) {
  bool all_done = false;
  view([&](testing::WindowFromOutside& window) {
    for (const auto& [width, height] : {std::pair(1u, 1u), std::pair(300u, 2u), std::pair(1u, 200u),
                                        std::pair(16384u, 64u), std::pair(64u, 48u)}) {
      window.resize(width, height);
      std::this_thread::sleep_for(50ms);
    }
    all_done = true;
  });
  EXPECT_TRUE(all_done);
}

}  // namespace
}  // namespace prairie
