// The table of all that a person can do in the viewer, and what its keys do to a session, without a window.
#include "app/viewer/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "app/viewer/key_help.h"
#include "tests/app/viewer/walking_world.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::walking_scene;
using testing::walking_world;

/// A session in a window nobody sees, and keys pressed in it.
struct Pressed {
  explicit Pressed(World shown) : world(std::move(shown)), session(world, start(), {}) {}

  static Camera start() {
    Camera camera;
    camera.eye_m = {32.0, 20.0, 5.0};
    return camera;
  }

  Pressed& press(const std::vector<Key>& keys) {
    for (const Key key : keys) prairie::press(key, actions, session);
    return *this;
  }

  World world;
  Session session;
  const std::vector<Action> actions = viewer_actions();
};

World empty_world() {
  return World(walking_scene(""), {});
}

bool has_key(const Action& action, Key key) {
  return std::find(action.keys.begin(), action.keys.end(), key) != action.keys.end();
}

std::vector<std::string> available_with(Key key, const Pressed& pressed) {
  std::vector<std::string> names;
  for (const Action& action : pressed.actions)
    if (has_key(action, key) && action.is_available(pressed.session)) names.push_back(action.name);
  return names;
}

TEST(Actions, EachHasANameOfItsOwnAndTellsWhatItDoes) {
  std::set<std::string> names, menus;
  std::string menu;
  for (const Action& action : viewer_actions()) {
    EXPECT_TRUE(names.insert(action.name).second) << action.name;
    EXPECT_FALSE(action.help.empty()) << action.name;
    EXPECT_FALSE(action.label.empty()) << action.name;
    EXPECT_TRUE(std::all_of(action.label.begin(), action.label.end(), [](char c) { return c > 0; }))
        << "the window's font is ASCII: " << action.label;
    EXPECT_TRUE(action.perform || !action.has_button) << action.name;
    const bool begins_menu = action.menu != menu;
    EXPECT_TRUE(!begins_menu || menus.insert(action.menu).second) << "in two places: " << action.menu;
    menu = action.menu;
  }
}

TEST(Actions, NoKeyStandsForTwoAtATime) {
  for (const bool walked : {false, true}) {
    Pressed pressed(walked ? walking_world() : empty_world());
    std::mt19937 random(3);
    for (int n = 0; n < 300; ++n) {
      for (const Action& action : pressed.actions) {
        for (const Key key : action.keys) {
          const std::vector<std::string> names = available_with(key, pressed);
          ASSERT_LE(names.size(), 1u) << key_name(key) << ": " << names[0] << ", " << names[1];
        }
      }
      perform(pressed.actions[random() % pressed.actions.size()].name, pressed.actions, pressed.session);
    }
  }
}

TEST(Actions, TheManualListsTheKeys) {
  std::vector<KeyHelp> listed;
  std::ifstream manual(PRAIRIE_SOURCES "/docs/manual.md");
  std::string line;
  while (std::getline(manual, line) && line != "| key | action |") {
  }
  std::getline(manual, line);
  while (std::getline(manual, line) && line.starts_with("| ")) {
    std::erase(line, '`');
    const std::size_t middle = line.find(" | ", 2);
    ASSERT_NE(middle, std::string::npos) << line;
    listed.push_back({line.substr(2, middle - 2), line.substr(middle + 3, line.size() - middle - 5)});
  }
  const std::vector<KeyHelp> help = key_help(viewer_actions());
  ASSERT_EQ(listed.size(), help.size());
  for (std::size_t n = 0; n < help.size(); ++n) {
    EXPECT_EQ(listed[n].keys, help[n].keys);
    EXPECT_EQ(listed[n].help, help[n].help) << help[n].keys;
  }
}

TEST(Actions, QualityGoesUpAndDownAndStaysInRange) {
  const auto after = [](const std::vector<Key>& keys) {
    Pressed pressed(empty_world());
    pressed.session.frame_options.quality = Quality::kMedium;
    return pressed.press(keys).session.frame_options.quality.value();
  };
  EXPECT_EQ(after({}), Quality::kMedium);
  EXPECT_EQ(after({'='}), Quality::kHigh);
  EXPECT_EQ(after({NamedKey::kKeypadAdd, '='}), Quality::kHigh);
  EXPECT_EQ(after({'-'}), Quality::kLow);
  EXPECT_EQ(after({NamedKey::kKeypadSubtract, '-', '='}), Quality::kMedium);
}

TEST(Actions, KeysChangeHowFramesAreDrawn) {
  Pressed pressed(empty_world());
  const FrameOptions& options = pressed.session.frame_options;
  pressed.press({'T', 'T', 'O', 'G', 'M'});
  EXPECT_EQ(options.tier, Tier::kHermite);
  EXPECT_EQ(options.field_overlay, FieldOverlay::kWind);
  EXPECT_TRUE(options.tier_tint);
  EXPECT_TRUE(options.msaa);
  pressed.press({'T', 'T', 'T', 'O', 'O', 'O', 'G', 'M'});
  EXPECT_EQ(options.tier, Tier::kAuto);
  EXPECT_EQ(options.field_overlay, FieldOverlay::kNone);
  EXPECT_FALSE(options.tier_tint);
  EXPECT_FALSE(options.msaa);
}

TEST(Actions, TimePausesAndIsSteppedOnlyThen) {
  Pressed pressed(empty_world());
  pressed.press({'N', 'P', 'N', 'N'});
  EXPECT_TRUE(pressed.session.play.paused());
  pressed.session.advance(1.0, {}, false);
  EXPECT_NEAR(pressed.world.time_s(), 2.0 / 30.0, 1e-6);
  EXPECT_FALSE(pressed.press({'P'}).session.play.paused());
}

TEST(Actions, KeysSetTheWind) {
  Pressed pressed(empty_world());
  const WindControls before = pressed.session.play.wind();
  pressed.press({']', ']', ']', '[', '.', '.', '.', ',', '\'', '\'', ';'});
  const WindControls& wind = pressed.session.play.wind();
  EXPECT_EQ(wind.speed_m_per_s, before.speed_m_per_s + 2.0f);
  EXPECT_EQ(wind.heading_deg, before.heading_deg + 30.0f);
  EXPECT_EQ(wind.turbulence, before.turbulence + 0.25f);
  pressed.press({'B', 'V'});
  EXPECT_EQ(pressed.world.motion().wind().primitives.size(), 2u);
}

TEST(Actions, StoneAndCart) {
  Pressed pressed(empty_world());
  pressed.press({'R', 'R', 'C'});
  EXPECT_TRUE(pressed.session.play.has_cart());
  EXPECT_EQ(pressed.world.driven().size(), 2u);
  pressed.press({'C'});
  EXPECT_FALSE(pressed.session.play.has_cart());
  EXPECT_EQ(pressed.world.driven().size(), 1u);
}

TEST(Actions, KeysWatchFollowAndSteerWalkers) {
  Pressed pressed(walking_world());
  const Session& session = pressed.session;
  pressed.press({'U'});
  EXPECT_FALSE(session.notice.empty()) << "nobody is watched";
  pressed.press({'K', 'J', 'X'});
  ASSERT_TRUE(session.camera.watched());
  EXPECT_EQ(session.camera.mode(), CameraMode::kFollow);
  EXPECT_EQ(session.walker_overlay, WalkerOverlay::kSensors);
  EXPECT_TRUE(session.notice.empty()) << "read meanwhile";
  pressed.press({'U'});
  EXPECT_EQ(session.steering.steered(), session.camera.watched());
  pressed.press({'K'});
  EXPECT_FALSE(session.steering.steered()) << "another one is watched";
}

TEST(Actions, NobodyIsWatchedWhereNobodyWalks) {
  Pressed pressed(empty_world());
  pressed.press({'K', 'J', 'U', 'X'});
  EXPECT_FALSE(pressed.session.camera.watched());
  EXPECT_EQ(pressed.session.camera.mode(), CameraMode::kFree);
  EXPECT_EQ(pressed.session.walker_overlay, WalkerOverlay::kNone);
  EXPECT_TRUE(pressed.session.notice.empty());
}

TEST(Actions, TheWindowIsAskedForItsPart) {
  Pressed pressed(empty_world());
  const bool walked = pressed.session.camera.walks();
  pressed.press({'F', 'H', NamedKey::kF12, NamedKey::kEscape});
  EXPECT_NE(pressed.session.camera.walks(), walked);
  EXPECT_FALSE(pressed.session.panels_shown);
  EXPECT_TRUE(pressed.session.picture_wanted);
  EXPECT_TRUE(pressed.session.end_wanted);
}

TEST(Actions, AnyKeyHasReadTheNotice) {
  Pressed pressed(empty_world());
  pressed.session.notice = "saved prairie-0001.png";
  pressed.press({NamedKey::kOther});
  EXPECT_TRUE(pressed.session.notice.empty());
}

TEST(Actions, ThoseOfAnotherFolderFollowTheViewers) {
  Pressed pressed(empty_world());
  std::vector<Action> actions = viewer_actions();
  int dug = 0;
  actions.push_back({.name = "dig",
                     .menu = "ground",
                     .keys = {'Z'},
                     .label = "dig",
                     .help = "dig a hole",
                     .perform = [&dug](Session&) { ++dug; },
                     .is_available = [](const Session& session) { return session.play.paused(); }});
  for (const char key : {'Z', 'P', 'Z'}) press(key, actions, pressed.session);
  perform("dig", actions, pressed.session);
  EXPECT_EQ(dug, 2);
  EXPECT_EQ(key_help(actions).back(), (KeyHelp{"Z", "dig a hole"}));
}

}  // namespace
}  // namespace prairie
