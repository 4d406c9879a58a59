// States on the command line: a run that is cut in two by a file draws what one in one piece draws, and what
// is no state of the scene is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

class States : public ::testing::Test {
 protected:
  States() {
    testing::write_small_scene(folder_ / "scene");
    // The stone rolls before the camera.
    testing::write_text(folder_ / "scene" / "scene.toml", testing::small_scene_toml() + R"([wind]
speed_m_per_s = 6
heading_deg = 60
[[mover]]
name = "stone"
path_m = [[5, 6], [12, 7]]
)");
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return testing::prairie(arguments);
  }
  Outcome render(const std::string& picture, const std::vector<std::string>& more) const {
    return run({"render", scene_, "-o", path(picture), "--size", "160x90"}, more);
  }
  Outcome export_tile(const std::string& folder, const std::vector<std::string>& more) const {
    return run({"export", scene_, "-o", path(folder), "--size", "96x64", "--tiles", "1,1,1,1"}, more);
  }
  std::vector<std::byte> bytes(const std::string& name) const { return testing::read_bytes(folder_ / name); }

  static void expect_refused(const Outcome& outcome, int exit_code,
                             const std::vector<std::string>& mentions) {
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    for (const std::string& mention : mentions)
      EXPECT_NE(outcome.err.find(mention), std::string::npos) << mention;
  }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

TEST_F(States, AClipGoesOn) {
  const auto record = [&](const std::string& folder, const std::vector<std::string>& more) {
    return run({"record", scene_, "-o", path(folder), "--size", "96x64", "--fps", "24"}, more).exit_code;
  };
  ASSERT_EQ(record("whole", {"--duration", "0.5"}), 0);
  ASSERT_EQ(record("first", {"--duration", "0.25", "--save-state", path("clip.state")}), 0);
  ASSERT_EQ(record("second", {"--duration", "0.25", "--load-state", path("clip.state"), "--threads", "1"}),
            0);
  for (int frame = 0; frame < 6; ++frame) {
    const std::string name = "/frame-0000" + std::to_string(frame) + ".png";
    EXPECT_EQ(bytes("first" + name), bytes("whole" + name)) << frame;
    const std::string later = frame + 6 < 10 ? "/frame-0000" + std::to_string(frame + 6) + ".png"
                                             : "/frame-000" + std::to_string(frame + 6) + ".png";
    EXPECT_EQ(bytes("second" + name), bytes("whole" + later)) << frame;
  }
}

TEST_F(States, RenderGoesOn) {
  ASSERT_EQ(render("whole.png", {"--time", "2", "--save-state", path("whole.state")}).exit_code, 0);
  const Outcome half = render("half.png", {"--time", "1", "--save-state", path("half.state")});
  ASSERT_EQ(half.exit_code, 0) << half.err;
  const Outcome rest = render("rest.png", {"--time", "2", "--load-state", path("half.state"), "--save-state",
                                           path("rest.state"), "--threads", "1"});
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(bytes("rest.png"), bytes("whole.png"));
  EXPECT_EQ(bytes("rest.state"), bytes("whole.state"));
  EXPECT_NE(bytes("half.png"), bytes("whole.png"));

  // Without a time the picture is of the state's.
  ASSERT_EQ(
      render("again.png", {"--load-state", path("half.state"), "--save-state", path("half.state")}).exit_code,
      0);
  EXPECT_EQ(bytes("again.png"), bytes("half.png"));
  // And the state that was replaced by itself is still one.
  EXPECT_EQ(render("again.png", {"--load-state", path("half.state"), "--time", "1"}).exit_code, 0);
  EXPECT_EQ(bytes("again.png"), bytes("half.png"));
}

TEST_F(States, ExportGoesOn) {
  ASSERT_EQ(export_tile("whole", {"--time", "2"}).exit_code, 0);
  ASSERT_EQ(
      export_tile("half", {"--time", "1", "--views", "top", "--save-state", path("half.state")}).exit_code,
      0);
  const Outcome rest = export_tile("rest", {"--time", "2", "--load-state", path("half.state")});
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(bytes("rest/manifest.json"), bytes("whole/manifest.json")) << "with the hashes of the pictures";
  EXPECT_EQ(bytes("rest/tile_1_1_eye_auto.png"), bytes("whole/tile_1_1_eye_auto.png"));
  EXPECT_NE(bytes("half/tile_1_1_top_auto.png"), bytes("whole/tile_1_1_top_auto.png"));
  std::ifstream file(path("rest/manifest.json"));
  EXPECT_EQ(nlohmann::json::parse(file)["time_s"], 2.0);
}

TEST_F(States, ExportedTilesDoNotDependOnWhichOthersAre) {
  ASSERT_EQ(export_tile("alone", {"--time", "1", "--views", "eye"}).exit_code, 0);
  ASSERT_EQ(run({"export", scene_, "-o", path("with_others"), "--size", "96x64"},
                {"--tiles", "0,0,1,1", "--views", "eye,oblique", "--time", "1"})
                .exit_code,
            0);
  EXPECT_EQ(bytes("alone/tile_1_1_eye_auto.png"), bytes("with_others/tile_1_1_eye_auto.png"));
}

TEST_F(States, TimeDoesNotGoBackwards) {
  ASSERT_EQ(render("a.png", {"--time", "1.5", "--save-state", path("a.state")}).exit_code, 0);
  testing::write_text(folder_ / "a.png", "before");
  expect_refused(render("a.png", {"--time", "1", "--load-state", path("a.state")}), 2,
                 {"--time", "1 s", "1.5 s"});
  expect_refused(export_tile("tiles", {"--time", "1", "--load-state", path("a.state")}), 2,
                 {"--time", "1.5 s"});
  EXPECT_EQ(fs::file_size(folder_ / "a.png"), 6u);
}

TEST_F(States, WhatIsNoStateOfTheScene) {
  ASSERT_EQ(render("a.png", {"--time", "0.5", "--save-state", path("a.state")}).exit_code, 0);
  const auto refused = [&](const std::string& name, const std::vector<std::string>& mentions,
                           const std::vector<std::string>& more = {}) {
    testing::write_text(folder_ / "a.png", "before");
    std::vector<std::string> arguments{"--load-state", path(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(render("a.png", arguments), 3, mentions);
    EXPECT_EQ(fs::file_size(folder_ / "a.png"), 6u);
  };
  refused("a.state", {"a.state", "another scene"}, {"--set", "wind.speed_m_per_s=5"});
  refused("a.state", {"a.state", "another scene"}, {"--seed", "9"});
  refused("none.state", {"none.state", "No such file"});
  refused("scene", {"scene", "a folder"});
  refused("scene/ground.tif", {"ground.tif", "no state"});
  testing::write_text(folder_ / "empty.state", "");
  refused("empty.state", {"empty.state", "an empty file"});

  std::vector<std::byte> whole = bytes("a.state");
  whole[100] ^= std::byte{4};
  testing::write_bytes(folder_ / "damaged.state", whole);
  refused("damaged.state", {"damaged.state", "damaged"});
  fs::resize_file(folder_ / "a.state", fs::file_size(folder_ / "a.state") - 1);
  refused("a.state", {"a.state", "cut short"});
  // Longer than any state; no disk is needed for its zeros.
  testing::write_text(folder_ / "long.state", "PRS");
  fs::resize_file(folder_ / "long.state", (std::uintmax_t{1} << 30) + 1);
  refused("long.state", {"long.state", "at most 1073741824"});
}

TEST_F(States, PlacesThatTakeNoState) {
  for (const std::string& place : {scene_, path("none/a.state"), std::string("/proc/a.state")}) {
    const Outcome outcome = render("a.png", {"--save-state", place});
    expect_refused(outcome, 1, {place.substr(0, place.find("/a.state"))});
    EXPECT_FALSE(fs::exists(folder_ / "a.png"));
  }
  expect_refused(export_tile("tiles", {"--save-state", scene_}), 1, {"a folder"});
}

TEST_F(States, OfAReplayAreDrawnWithTheSameTracks) {
  testing::write_text(folder_ / "tracks.csv",
                      "time_s,id,x_m,y_m\n0,1,4,4\n1,1,5.3,4\n2,1,6.6,4\n3,1,7.9,4\n");
  const std::vector<std::string> tracks{"--replay", path("tracks.csv")};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), tracks.begin(), tracks.end());
    return more;
  };
  ASSERT_EQ(run({"walk", scene_}, with({"--duration", "2", "--save-state", path("s.state")})).exit_code, 0);
  const Outcome drawn = render("a.png", with({"--load-state", path("s.state")}));
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(export_tile("tiles", with({"--load-state", path("s.state")})).exit_code, 0);
  EXPECT_EQ(run({"record", scene_, "-o", path("clip"), "--duration", "0.1", "--size", "64x64"},
                with({"--load-state", path("s.state")}))
                .exit_code,
            0);
  expect_refused(render("b.png", {"--load-state", path("s.state")}), 3, {"s.state"});
}

TEST_F(States, TracksBesideTheGroundAreWarnedOf) {
  testing::write_text(folder_ / "away.csv", "time_s,id,x_m,y_m\n0,1,5000,5000\n1,1,5001.3,5000\n");
  const Outcome outcome = run({"walk", scene_, "--replay", path("away.csv"), "--duration", "1"}, {});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* part : {"away.csv", "onto the ground", "--replay-at"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace prairie
