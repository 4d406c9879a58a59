// `prairie record`: clips of the right size and length, the same every time, whole or not there.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Call;
using testing::Outcome;
using Words = std::vector<std::string>;

bool is_installed(const std::string& program) {
  Call call;
  call.program = program;
  call.arguments = {"-version"};
  return testing::run(call).exit_code == 0;
}

class Record : public ::testing::Test {
 protected:
  Record() { testing::write_small_scene(folder_ / "scene"); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// A short and small clip, but for what `more` asks for.
  Words words(const std::string& output, const Words& more = {}) const {
    Words all{"record", scene_, "-o", path(output)};
    all.insert(all.end(), more.begin(), more.end());
    for (const auto& [option, value] :
         {std::pair("--size", "64x48"), {"--fps", "8"}, {"--duration", "0.5"}}) {
      if (std::ranges::find(more, option) == more.end()) all.insert(all.end(), {option, value});
    }
    return all;
  }
  Outcome record(const std::string& output, const Words& more = {}) const {
    return testing::prairie(words(output, more));
  }

  Words files_in(const std::string& name) const {
    Words names;
    for (const auto& entry : fs::directory_iterator(folder_ / name)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

void expect_one_line(const Outcome& outcome, int exit_code, const Words& mentions) {
  SCOPED_TRACE(outcome.err);
  EXPECT_EQ(outcome.exit_code, exit_code);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
  for (const std::string& mention : mentions)
    EXPECT_NE(outcome.err.find(mention), std::string::npos) << mention;
}

const std::string kPath = "time_s,x_m,y_m,z_m,yaw_deg,pitch_deg\n0,4,1,+1.7,350,-10\n0.25,8,2,+1.5,10,-20\n";

TEST_F(Record, PicturesAreCompleteAndTheSameEveryTime) {
  testing::write_text(folder_ / "path.csv", kPath);
  const Words moving{"--path", path("path.csv"), "--time", "0.2"};
  const Outcome outcome = record("one", moving);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  ASSERT_EQ(record("two/deeper", moving).exit_code, 0);
  EXPECT_EQ(files_in("one"),
            (Words{"frame-00000.png", "frame-00001.png", "frame-00002.png", "frame-00003.png"}));
  for (const std::string& name : files_in("one")) {
    const auto input = OIIO::ImageInput::open(path("one/" + name));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 64);
    EXPECT_EQ(input->spec().height, 48);
    EXPECT_EQ(testing::read_bytes(folder_ / "one" / name),
              testing::read_bytes(folder_ / "two/deeper" / name));
  }
  EXPECT_NE(testing::read_bytes(folder_ / "one/frame-00000.png"),
            testing::read_bytes(folder_ / "one/frame-00001.png"))
      << "the camera moves";
}

TEST_F(Record, PictureIsThatOfRender) {
  ASSERT_EQ(record("clip", {"--camera", "8,1,+1.7,0,-10", "--samples", "2", "--tier", "hermite"}).exit_code,
            0);
  ASSERT_EQ(testing::prairie({"render", scene_, "-o", path("a.png"), "--size", "64x48", "--camera",
                              "8,1,+1.7,0,-10", "--samples", "2", "--tier", "hermite"})
                .exit_code,
            0);
  EXPECT_EQ(testing::read_bytes(folder_ / "clip/frame-00000.png"), testing::read_bytes(folder_ / "a.png"));
}

TEST_F(Record, PathGivesTheDuration) {
  testing::write_text(folder_ / "path.csv", kPath);
  ASSERT_EQ(testing::prairie({"record", scene_, "-o", path("a"), "--size", "8x8", "--fps", "12", "--path",
                              path("path.csv")})
                .exit_code,
            0);
  EXPECT_EQ(files_in("a").size(), 3u);
}

TEST_F(Record, WarnsOfFramesThatFollow) {
  fs::create_directory(folder_ / "a");
  testing::write_text(folder_ / "a/frame-00004.png", "old");
  const Outcome outcome = record("a");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("earlier"), std::string::npos) << outcome.err;
}

TEST_F(Record, VideoHasItsFramesAndSize) {
  if (!is_installed("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  testing::write_text(folder_ / "-a:b.mp4", "before");
  const Outcome outcome = record("-a:b.mp4", {"--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(files_in("."), (Words{"-a:b.mp4", "scene"}));
  if (!is_installed("ffprobe")) GTEST_SKIP() << "ffprobe is not installed";
  Call probe;
  probe.program = "ffprobe";
  probe.arguments = {"-v",
                     "error",
                     "-count_frames",
                     "-show_entries",
                     "stream=codec_name,width,height,pix_fmt,color_space,r_frame_rate,nb_read_frames",
                     "-of",
                     "default=noprint_wrappers=1",
                     "file:" + path("-a:b.mp4")};
  const std::string found = testing::run(probe).out;
  for (const std::string line : {"codec_name=h264\n", "width=64\n", "height=48\n", "pix_fmt=yuv420p\n",
                                 "color_space=bt709\n", "r_frame_rate=8/1\n", "nb_read_frames=4\n"})
    EXPECT_NE(found.find(line), std::string::npos) << line << found;
}

TEST_F(Record, MissingFfmpeg) {
  for (const std::string search : {"", "/nonexistent"}) {
    testing::write_text(folder_ / "a.mp4", "before");
    Call call;
    call.arguments = words("a.mp4");
    call.environment = {{"PATH", search}};
    expect_one_line(testing::run(call), 1, {"a.mp4", "ffmpeg", "PATH"});
    EXPECT_EQ(fs::file_size(folder_ / "a.mp4"), 6u);
    EXPECT_EQ(files_in("."), (Words{"a.mp4", "scene"}));
  }
}

/// A program by that name in place of the real one.
void write_ffmpeg(const fs::path& folder, const std::string& script) {
  fs::create_directory(folder);
  testing::write_text(folder / "ffmpeg", "#!/bin/sh\n" + script);
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
}

TEST_F(Record, FfmpegThatFailsIsQuoted) {
  // At once, so that writing to it fails; and after it has taken all.
  const Words scripts{"echo first >&2; echo no such encoder >&2; exit 7\n",
                      "cat >/dev/null; echo no such encoder >&2; exit 7\n"};
  for (std::size_t n = 0; n < scripts.size(); ++n) {
    write_ffmpeg(folder_ / fmt::format("bin{}", n), scripts[n]);
    fs::create_directory(folder_ / fmt::format("out{}", n));
    Call call;
    call.arguments = words(fmt::format("out{}/a.mp4", n));
    call.environment = {{"PATH", path(fmt::format("bin{}", n)) + ":/usr/bin:/bin"}};
    expect_one_line(testing::run(call), 1, {"a.mp4", "ffmpeg", "no such encoder", "exit code 7"});
    EXPECT_EQ(files_in(fmt::format("out{}", n)), Words{});
  }
}

TEST_F(Record, InterruptedLeavesNothingBehind) {
  // One that would write its file at the end of its input, as the real one does.
  write_ffmpeg(folder_ / "bin", "for last; do :; done; cat >/dev/null; echo half >\"${last#file:}\"\n");
  fs::create_directory(folder_ / "out");
  testing::write_text(folder_ / "out/a.mp4", "before");
  Call call;
  call.arguments = words("out/a.mp4", {"--duration", "1000"});
  call.environment = {{"PATH", path("bin") + ":/usr/bin:/bin"}};
  testing::Running running(call);
  for (int wait = 0; wait < 500 && files_in("out").size() < 2; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(files_in("out").size(), 2u) << "the temporary file";
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(running.process(), SIGINT);
  EXPECT_EQ(running.finish().exit_code, 128 + SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(files_in("out"), Words{"a.mp4"});
  EXPECT_EQ(fs::file_size(folder_ / "out/a.mp4"), 6u);
}

TEST_F(Record, RefusesWhatItCannotMake) {
  expect_one_line(record("a.mp4", {"--size", "63x48"}), 2, {"--size", "63x48", "even"});
  expect_one_line(record("a.webm"), 2, {"a.webm", ".mp4"});
  expect_one_line(record("a", {"--fps", "0"}), 2, {"--fps"});
  expect_one_line(record("a", {"--duration", "80000"}), 2, {"--duration", "frames"});
  expect_one_line(record("a", {"--camera", "default", "--path", "b.csv"}), 2, {"--path", "--camera"});
  expect_one_line(record("none/a.mp4"), 1, {"none"});
  EXPECT_EQ(files_in("."), Words{"scene"});
}

TEST_F(Record, BadPathNamesLineAndColumn) {
  const auto refused = [&](const std::string& text, const Words& mentions) {
    testing::write_text(folder_ / "path.csv", text);
    Words all{"path.csv"};
    all.insert(all.end(), mentions.begin(), mentions.end());
    expect_one_line(record("a", {"--path", path("path.csv")}), 3, all);
    EXPECT_FALSE(fs::exists(folder_ / "a"));
  };
  refused(kPath + "1,8,x,+1.5,0,0\n", {"line 4: y_m", "\"x\""});
  refused(kPath + "1,8,nan,+1.5,0,0\n", {"line 4: y_m", "\"nan\""});
  refused("", {"empty"});
  expect_one_line(record("a", {"--path", path("none.csv")}), 3, {"none.csv"});
}

}  // namespace
}  // namespace prairie
