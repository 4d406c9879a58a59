// Windows that are hidden, resized and brought back, seen from the X server, to which this test talks like a
// window manager. Run under xvfb-run.
#include "app/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/viewer/view.h"
#include "lod/camera.h"
#include "tests/app/small_scene.h"
#include "tests/app/viewer/window_from_outside.h"
#include "tests/maps/test_images.h"
#include "world/motion.h"
#include "world/scene/scene.h"
#include "world/world.h"

namespace prairie {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// X's symbols, whose header defines macros.
constexpr unsigned long kEscape = 0xff1b, kLeft = 0xff51, kUp = 0xff52, kKeypadAdd = 0xffab,
                        kKeypadSubtract = 0xffad, kF12 = 0xffc9, kShift = 0xffe1, kControl = 0xffe3;

/// Two walkers in sight of the camera, the first straight ahead.
constexpr const char* kWalkers = R"([[walkers]]
name = "two"
starts_m = [[8, 10], [12, 9]]
)";

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

TEST(WindowTest, CountsTheWheel) {
  Window window({64, 48});
  testing::WindowFromOutside outside;
  ASSERT_TRUE(outside.is_there());
  const auto turned = [&](bool mouse_is_taken) {
    for (int n = 0; n < 3; ++n) outside.turn_wheel();
    window.poll();
    return window.steering(mouse_is_taken).wheel;
  };
  EXPECT_EQ(turned(false), 3.0);
  EXPECT_EQ(window.steering(false).wheel, 0.0);
  EXPECT_EQ(turned(true), 0.0);
  EXPECT_EQ(window.steering(false).wheel, 0.0) << "what turned over the text is forgotten";
}

TEST(WindowTest, PassesKeysOn) {
  Window window({64, 48});
  testing::WindowFromOutside outside;
  ASSERT_TRUE(outside.is_there());
  std::vector<Key> keys;
  window.on_key = [&keys](Key key) { keys.push_back(key); };
  const std::vector<unsigned long> pressed{'p',  '[',    '\'',  '=',      '-',    kKeypadAdd, kKeypadSubtract,
                                           kF12, kShift, kLeft, kControl, kEscape};
  for (const unsigned long symbol : pressed) outside.press(symbol);
  window.poll();
  EXPECT_EQ(keys, (std::vector<Key>{'P', '[', '\'', '=', '-', NamedKey::kKeypadAdd, NamedKey::kKeypadSubtract,
                                    NamedKey::kF12, NamedKey::kShift, NamedKey::kArrows, NamedKey::kOther,
                                    NamedKey::kEscape}));
}

class ViewerTest : public ::testing::Test {
 protected:
  ViewerTest() { testing::write_small_scene(folder_ / "scene"); }

  /// Shows the scene, while `disturb` does something to the window, which is then closed.
  void view(const std::function<void(testing::WindowFromOutside&)>& disturb) {
    World world(read_scene(folder_ / "scene", {}), {});
    view(world, {}, disturb);
  }

  void view(World& world, ViewerOptions options,
            const std::function<void(testing::WindowFromOutside&)>& disturb) {
    Camera camera;
    camera.eye_m = {8.0, 1.0, 3.0};
    camera.size_px = {64, 48};
    options.memory_budget_bytes = std::uint64_t{1} << 30;
    const std::jthread other([&] {
      testing::WindowFromOutside window;
      ASSERT_TRUE(window.is_there());
      disturb(window);
      if (!ends_itself_) window.close();
    });
    view_world(world, camera, options);
  }

  /// The world after these keys were pressed, all before the first frame, while time paused.
  World after_keys(const std::vector<unsigned long>& keys, const std::filesystem::path& screenshot = {}) {
    World world(read_scene(folder_ / "scene", {}), {});
    ViewerOptions options;
    options.paused = true;
    if (!screenshot.empty()) options.screenshot = screenshot;
    view(world, options, [&](testing::WindowFromOutside& window) {
      for (const unsigned long key : keys) window.press(key);
    });
    return world;
  }

  /// The scene with two walkers.
  World walking_world() const {
    return World(parse_scene(testing::small_scene_toml() + kWalkers, folder_ / "scene", {}), {});
  }

  /// What the window then shows.
  std::string picture_after(std::vector<unsigned long> keys, int overlays) {
    keys.insert(keys.end(), static_cast<std::size_t>(overlays), 'o');
    after_keys(keys, folder_ / "seen.png");
    std::ifstream file(folder_ / "seen.png", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const TemporaryFolder folder_;
  bool ends_itself_ = false;  // what is done to the window closes it
};

TEST_F(ViewerTest, TimePassesUnlessItPauses) {
  World world(read_scene(folder_ / "scene", {}), {});
  // Until long after the first frame, whose shaders may have to be compiled.
  view(world, {}, [](testing::WindowFromOutside&) { std::this_thread::sleep_for(2s); });
  EXPECT_GT(world.time_s(), 0.0);
  EXPECT_EQ(after_keys({}).time_s(), 0.0);
  EXPECT_GT(after_keys({'p', 'p', 'n'}).time_s(), 0.0);
  EXPECT_NEAR(after_keys({'n', 'n', 'n'}).time_s(), 0.1, 1e-6);
}

TEST_F(ViewerTest, AStoneLeavesATrack) {
  EXPECT_EQ(after_keys({'n', 'n'}).motion().treading().bytes(), 0u);
  std::vector<unsigned long> keys(20, 'n');
  keys.insert(keys.begin(), 'r');
  const World world = after_keys(keys);
  EXPECT_GT(world.motion().treading().bytes(), 0u);
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_NEAR(world.driven()[0].place.contact_m.y, 1.0 + 4.0 + 2.0 * 20.0 / 30.0, 1e-3);
}

TEST_F(ViewerTest, ACartIsTakenAndLeft) {
  const World world = after_keys({'c', 'n'});
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_EQ(world.driven()[0].kind, MoverKind::kCart);
  EXPECT_TRUE(after_keys({'c', 'n', 'c', 'n'}).driven().empty());
}

TEST_F(ViewerTest, ArrowKeysDriveTheCart) {
  World world(read_scene(folder_ / "scene", {}), {});
  ViewerOptions options;
  options.paused = true;
  view(world, options, [](testing::WindowFromOutside& window) {
    window.hold(kUp);
    window.hold(kLeft);
    for (const char key : std::string("cnnnnnnnnnnnnnnn")) window.press(static_cast<unsigned long>(key));
  });
  ASSERT_EQ(world.driven().size(), 1u);
  const DrivenMover& cart = world.driven()[0];
  EXPECT_GT(cart.rolled_m, 0.1);
  EXPECT_LT(cart.place.forward.x, -1e-3) << "to the left of north";
}

TEST_F(ViewerTest, WindGustsAndTornadoes) {
  const World world = after_keys({']', ']', ']', ';', 'b', 'v', 'n'});
  EXPECT_EQ(world.motion().wind().primitives.size(), 2u);
  EXPECT_TRUE(world.motion().wind().noise);
  EXPECT_TRUE(world.motion().sway());
  const glm::dvec2 mean = world.motion().wind().mean.velocity_m_per_s({0.0, 0.0}, 0.0);
  EXPECT_NEAR(mean.x, 3.0, 1e-5);
}

TEST_F(ViewerTest, OverlaysChangeThePicture) {
  const std::vector<unsigned long> windy{']', ']', ']', ']', 'n'};
  EXPECT_NE(picture_after(windy, 1), picture_after(windy, 0));
  std::vector<unsigned long> trodden(20, 'n');
  trodden.insert(trodden.begin(), 'r');
  const std::string plain = picture_after(trodden, 0), tilt = picture_after(trodden, 2);
  EXPECT_FALSE(plain.empty());
  EXPECT_NE(tilt, plain);
  EXPECT_NE(picture_after(trodden, 3), tilt);
  EXPECT_EQ(picture_after(trodden, 4), plain);
}

TEST_F(ViewerTest, ArrowKeysSteerTheWatchedWalker) {
  World world = walking_world();
  const glm::dvec2 start_m = world.walkers()[0].position_m, forward = world.walkers()[0].forward;
  ViewerOptions options;
  options.paused = true;
  view(world, options, [](testing::WindowFromOutside& window) {
    window.hold(kUp);
    for (const char key : std::string("ckunnnnnnnnnnnnnnnnnnnn"))
      window.press(static_cast<unsigned long>(key));
    std::this_thread::sleep_for(1s);  // until the first steps see that up is held
    for (const char key : std::string("nnnnnnnnnnnnnnnnnnnn")) window.press(static_cast<unsigned long>(key));
  });
  const glm::dvec2 way_m = world.walkers()[0].position_m - start_m;
  EXPECT_GT(glm::dot(way_m, forward), 0.3);
  EXPECT_NEAR(glm::dot(glm::normalize(way_m), forward), 1.0, 1e-6);
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_EQ(world.driven()[0].rolled_m, 0.0) << "the cart has no keys meanwhile";
  EXPECT_FALSE(world.crowd().is_steered(0)) << "given back at the end";
}

TEST_F(ViewerTest, TheCameraFollowsAndLinesShow) {
  const auto picture = [&](const std::string& keys, std::optional<std::size_t> follow, bool overlay) {
    World world = walking_world();
    ViewerOptions options;
    options.paused = true;
    options.follow = follow;
    options.walker_overlay = overlay;
    options.screenshot = folder_ / "seen.png";
    view(world, options, [&](testing::WindowFromOutside& window) {
      for (const char key : keys) window.press(static_cast<unsigned long>(key));
    });
    std::ifstream file(folder_ / "seen.png", std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  const std::string plain = picture("", {}, false), followed = picture("", 0, false);
  EXPECT_FALSE(plain.empty());
  EXPECT_NE(followed, plain);
  EXPECT_NE(picture("", 1, false), followed);
  EXPECT_EQ(picture("jj", 0, false), followed) << "free, the camera stays where it is";
  const std::string sensors = picture("x", 0, false), both = picture("", 0, true);
  EXPECT_NE(sensors, followed);
  EXPECT_EQ(both, sensors) << "nobody has walked yet";
  EXPECT_EQ(picture("xxxx", 0, false), followed);
}

TEST_F(ViewerTest, EscapeEndsIt) {
  ends_itself_ = true;
  World world(read_scene(folder_ / "scene", {}), {});
  view(world, {}, [](testing::WindowFromOutside& window) { window.press(kEscape); });
}

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
