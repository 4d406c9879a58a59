// `prairie walk` from outside: trajectories, states, replays, gaits, clips, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "agents/track_files.h"
#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using testing::Outcome;

class Walk : public ::testing::Test {
 protected:
  Walk() {
    testing::write_small_scene(folder_ / "scene");
    testing::write_text(folder_ / "scene" / "scene.toml", testing::small_scene_toml() + R"(
[[obstacle]]
kind = "trunk"
position_m = [8, 8]
[[wall]]
outline_m = [[0, 0], [16, 0], [16, 16], [0, 16]]
[[walkers]]
name = "people"
count = 6
position_m = [8, 8]
radius_m = 6
)");
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  Outcome walk(std::vector<std::string> more) const {
    more.insert(more.begin(), {"walk", (folder_ / "scene").string()});
    return testing::prairie(more);
  }
  std::string text(const std::string& name) const {
    const std::vector<std::byte> bytes = testing::read_bytes(folder_ / name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  void expect_refused(const std::vector<std::string>& more, int exit_code,
                      const std::vector<std::string>& mentions) const {
    const Outcome outcome = walk(more);
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    for (const std::string& mention : mentions)
      EXPECT_NE(outcome.err.find(mention), std::string::npos) << mention;
  }

  const TemporaryFolder folder_;
};

TEST_F(Walk, WritesTrajectoriesThatItReadsAgain) {
  const Outcome outcome = walk({"--duration", "2", "--trajectories", path("walk.csv")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string table = text("walk.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "time_s,id,x_m,y_m,z_m,heading_rad,speed_m_per_s,d_m,theta_rad,left_planted,right_planted");
  EXPECT_EQ(std::ranges::count(table, '\n'), 1 + 6 * 60);
  const std::vector<Track> tracks = parse_tracks(table, "walk.csv").tracks;
  ASSERT_EQ(tracks.size(), 6u);
  const Outcome again = walk({"--replay", path("walk.csv"), "--trajectories", path("again.csv")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const std::vector<Track> replayed = parse_tracks(text("again.csv"), "again.csv").tracks;
  ASSERT_EQ(replayed.size(), 6u);
  for (std::size_t n = 0; n < 6; ++n) {
    ASSERT_GE(replayed[n].positions_m.size(), 50u);
    for (std::size_t k = 0; k < 50; ++k) {
      EXPECT_NEAR(replayed[n].positions_m[k].x, tracks[n].positions_m[k].x, 0.01);
      EXPECT_NEAR(replayed[n].positions_m[k].y, tracks[n].positions_m[k].y, 0.01);
    }
  }
}

TEST_F(Walk, GoesOnFromAState) {
  ASSERT_EQ(
      walk({"--duration", "2", "--trajectories", path("whole.csv"), "--save-state", path("whole.state")})
          .exit_code,
      0);
  ASSERT_EQ(walk({"--duration", "1", "--trajectories", path("first.csv"), "--save-state", path("half.state"),
                  "--threads", "1"})
                .exit_code,
            0);
  ASSERT_EQ(walk({"--duration", "1", "--trajectories", path("second.csv"), "--load-state", path("half.state"),
                  "--save-state", path("rest.state")})
                .exit_code,
            0);
  const std::string second = text("second.csv");
  EXPECT_TRUE(text("first.csv") + second.substr(second.find('\n') + 1) == text("whole.csv"));
  EXPECT_TRUE(text("rest.state") == text("whole.state"));
}

TEST_F(Walk, RecordsAClip) {
  ASSERT_EQ(
      walk({"--record", path("clip"), "--duration", "0.1", "--size", "96x64", "--camera", "8,1,+1.7,0,-8"})
          .exit_code,
      0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "clip" / "frame-00002.png"));
}

TEST_F(Walk, RefusesWhatItCannotUse) {
  testing::write_text(folder_ / "text.csv", "time_s,id,x_m,y_m\n0,1,here,2\n");
  expect_refused({"--duration", "1", "--replay", path("text.csv")}, 3, {"text.csv", "x_m", "here"});
  testing::write_text(folder_ / "back.csv", "time_s,id,x_m,y_m\n1,1,1,2\n0.5,1,1,2\n");
  expect_refused({"--duration", "1", "--replay", path("back.csv")}, 3, {"back.csv"});
  testing::write_text(folder_ / "cm.csv", "time_s,id,x_m,y_m\n0,1,0,0\n1,1,130,0\n2,1,260,0\n");
  expect_refused({"--duration", "1", "--replay", path("cm.csv")}, 3, {"cm.csv", "centimetres"});
  expect_refused({"--duration", "1", "--replay", path("none.csv")}, 3, {"none.csv"});
  testing::write_text(folder_ / "half.bvh",
                      "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 0\n End Site\n {\n OFFSET 0 1 0\n "
                      "}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n\n");
  expect_refused({"--duration", "1", "--gait", path("half.bvh")}, 3, {"half.bvh"});
  expect_refused({"--replay-at", "1,2"}, 2, {"--replay"});
  expect_refused({"--duration", "80000"}, 2, {"--duration", "frames", "1000000"});
  expect_refused({"--duration", "4000", "--record", path("clip")}, 2, {"--duration", "frames", "100000"});
  expect_refused({"--duration", "1", "--replay", path("text.csv"), "--replay-at", "1"}, 2, {"--replay-at"});
  testing::write_small_scene(folder_ / "scene");
  expect_refused({"--duration", "1"}, 3, {"scene.toml", "walkers"});
}

TEST_F(Walk, StartsInANewFolder) {
  ASSERT_EQ(testing::prairie({"new", path("park"), "--walkers", "12"}).exit_code, 0);
  const Outcome outcome = testing::prairie({"walk", path("park"), "--duration", "1", "--trajectories", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1 + 12 * 30);
  EXPECT_EQ(testing::prairie({"new", path("crush"), "--walkers", "90000"}).exit_code, 2);
}

}  // namespace
}  // namespace prairie
