// What keys do, as text.
#include "app/viewer/key_help.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/viewer/actions.h"
#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

std::vector<Action> few_actions() {
  const auto nothing = [](Session&) {};
  return {{.name = "turn",
           .menu = "ground",
           .keys = {NamedKey::kArrows, 'Q'},
           .label = "turn",
           .help = "turn it"},
          {.name = "lower",
           .menu = "ground",
           .keys = {'1', NamedKey::kDelete},
           .label = "height",
           .help = "lower it",
           .perform = nothing},
          {.name = "raise",
           .menu = "ground",
           .keys = {'2'},
           .label = "height",
           .help = "raise it",
           .perform = nothing},
          {.name = "begin",
           .menu = "digging",
           .keys = {' '},
           .label = "dig",
           .help = "begin to dig",
           .perform = nothing,
           .is_available = [](const Session& session) { return session.play.paused(); }},
          {.name = "cease",
           .menu = "digging",
           .keys = {' '},
           .label = "cease",
           .help = "cease",
           .perform = nothing,
           .is_available = [](const Session& session) { return !session.play.paused(); }},
          {.name = "unheard",
           .menu = "digging",
           .keys = {},
           .label = "unheard",
           .help = "has a button only",
           .perform = nothing,
           .has_button = true}};
}

TEST(KeyHelp, NamesKeys) {
  EXPECT_EQ(key_name('P'), "P");
  EXPECT_EQ(key_name(' '), "space");
  EXPECT_EQ(key_name(NamedKey::kEscape), "Esc");
  EXPECT_EQ(key_name(NamedKey::kF1), "F1");
  EXPECT_EQ(key_name(NamedKey::kF12), "F12");
  EXPECT_EQ(key_name(NamedKey::kKeypadSubtract), "key pad -");
  EXPECT_EQ(key_name(NamedKey::kMouseWheel), "wheel");
}

TEST(KeyHelp, IsATable) {
  EXPECT_EQ(key_table(few_actions()),
            "  arrows, Q  turn it\n"
            "  1, Delete  lower it\n"
            "  2          raise it\n"
            "  space      begin to dig; cease\n");
}

TEST(KeyHelp, IsShortInTheWindow) {
  World world = testing::walking_world();
  Session session(world, {}, {});
  EXPECT_EQ(short_key_help(few_actions(), session),
            "ground   arrows Q: turn   1 2: height\n"
            "digging  space: cease");
  session.play.toggle_pause();
  EXPECT_NE(short_key_help(few_actions(), session).find("space: dig"), std::string::npos);
}

TEST(KeyHelp, FitsIntoTheWindow) {
  World world = testing::walking_world();
  ViewerOptions options;
  options.follow = 0;
  Session session(world, {}, options);
  session.steering.toggle(0);
  const std::string help = short_key_help(viewer_actions(), session);
  EXPECT_NE(help.find("walkers  K: next walker"), std::string::npos) << help;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 90u) << line;
}

}  // namespace
}  // namespace prairie
