// What the program says to command lines, good and bad: exit codes, help, the nearest word that was meant.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using testing::Outcome;

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& mentions) {
  const Outcome outcome = testing::prairie(arguments);
  SCOPED_TRACE(outcome.err);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
  EXPECT_TRUE(outcome.err.starts_with("prairie: "));
  EXPECT_NE(outcome.err.find(mentions), std::string::npos) << mentions;
}

TEST(CommandLine, VersionGoesToStdout) {
  const Outcome outcome = testing::prairie({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("prairie "));
  EXPECT_EQ(outcome.err, "");
}

TEST(CommandLine, EveryCommandHasHelpWithExamples) {
  for (const std::string command :
       {"new", "info", "render", "record", "export", "plant", "view", "walk", "bench"}) {
    const Outcome outcome = testing::prairie({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("Examples:\n  prairie " + command), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
  EXPECT_NE(testing::prairie({"--help"}).out.find("Examples:"), std::string::npos);
}

TEST(CommandLine, SuggestsWhatWasMeant) {
  expect_usage_error({"rendr", "x"}, "did you mean render?");
  expect_usage_error({"render", "x", "-o", "a.png", "--sise", "4x4"}, "did you mean --size?");
  expect_usage_error({"render", "x", "-o", "a.png", "--sed", "4"}, "did you mean --seed?");
  expect_usage_error({"render", "x", "-o", "a.png", "--tier", "flatt"}, "did you mean flat?");
  expect_usage_error({"export", "x", "-o", "a", "--views", "top,oblike"}, "did you mean oblique?");
  expect_usage_error({"bench", "planing"}, "planting.");
}

TEST(CommandLine, NamesWhatIsMissingOrTooMuch) {
  expect_usage_error({}, "no command");
  expect_usage_error({"render"}, "DIR");
  expect_usage_error({"render", "x"}, "--output");
  expect_usage_error({"info", "x", "y"}, "found y");
  expect_usage_error({"info", "x", "render"}, "found render");
}

TEST(CommandLine, ChecksEveryValue) {
  const auto render = [](const std::string& option, const std::string& value) {
    expect_usage_error({"render", "x", "-o", "a.png", option, value}, option);
  };
  for (const std::string size :
       {"0x5", "5", "5x", "x5", "5x5x5", "-5x5", "16385x1", "5x16385", "5.5x4", ""}) {
    render("--size", size);
  }
  for (const std::string samples : {"0", "1025", "-1", "1.5", "many", ""}) render("--samples", samples);
  for (const std::string seed : {"-1", "1.5", "x", "18446744073709551616", ""}) render("--seed", seed);
  for (const std::string threads : {"0", "-2", "1025", "two"}) render("--threads", threads);
  for (const std::string bytes : {"0", "-1", "12Q", "M", "1e99G", "nan", ""}) render("--max-memory", bytes);
  render("--output", "a.jpg");
  expect_usage_error({"plant", "x", "-o", "a.txt"}, "--output");
  for (const std::string tiles : {"1,2,3", "1,2,3,4,5", "a,b,c,d", "1.5,0,2,2", ""}) {
    expect_usage_error({"plant", "x", "-o", "a.csv", "--tiles", tiles}, "--tiles");
  }
  expect_usage_error({"export", "x", "-o", "a", "--views", ""}, "--views");
  expect_usage_error({"new", "x", "--density", "f.png", "--density-range", "1,1"}, "--density-range");
  expect_usage_error({"new", "x", "--density", "f.png", "--density-max", "1e9"}, "--density-max");
  expect_usage_error({"new", "x", "--density-curve", "2"}, "--density");
}

class CommandsOnAScene : public ::testing::Test {
 protected:
  CommandsOnAScene() { testing::write_small_scene(folder_ / "scene"); }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

TEST_F(CommandsOnAScene, ChecksWhatOnlyTheSceneKnows) {
  const std::string picture = (folder_ / "a.png").string();
  for (const std::string camera : {"defalt", "1,2,3", "1,2,+1.7,0,91", "1,2,+1.7,0,0,0", "1,2,+1.7,0,0,171",
                                   "a,2,+1.7,0,0", "nan,2,+1.7,0,0", "1,2,+1.7,0,0,60,7", "1e99,0,0,0,0"}) {
    expect_usage_error({"render", scene_, "-o", picture, "--camera", camera}, "--camera");
  }
  expect_usage_error({"plant", scene_, "-o", (folder_ / "a.csv").string(), "--tiles", "0,0,4,0"}, "0,0,3,3");
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST_F(CommandsOnAScene, GlobalOptionsMayComeFirstOrLast) {
  const Outcome first = testing::prairie({"--seed", "9", "info", scene_, "--json"});
  const Outcome last = testing::prairie({"info", scene_, "--json", "--seed", "9"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, last.out);
  EXPECT_NE(first.out, testing::prairie({"info", scene_, "--json"}).out);
}

TEST_F(CommandsOnAScene, OverridesASceneKeyRepeatedly) {
  const Outcome outcome =
      testing::prairie({"info", "--set", "seed=11", "--set", "tile_m=2.0", scene_, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"seed\": 11"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"tile_m\": 2"), std::string::npos) << outcome.out;
}

TEST_F(CommandsOnAScene, RefusesMemoryBeforeItIsSpent) {
  const Outcome outcome = testing::prairie({"render", scene_, "-o", (folder_ / "a.png").string(), "--size",
                                            "16384x16384", "--max-memory", "256M"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("--max-memory"), std::string::npos) << outcome.err;
  EXPECT_LT(outcome.largest_memory_mib, 256);
}

TEST_F(CommandsOnAScene, QuietSaysNothing) {
  const Outcome outcome = testing::prairie({"plant", scene_, "-q", "-o", (folder_ / "a.csv").string()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

}  // namespace
}  // namespace prairie
