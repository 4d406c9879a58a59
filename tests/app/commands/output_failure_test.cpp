// Outputs that cannot be written: exit code 1, one line that names the output, nothing half-written, and what
// stood there before intact.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Call;
using testing::Outcome;

class Output : public ::testing::Test {
 protected:
  Output() { testing::write_small_scene(folder_ / "scene"); }

  static void expect_failure(const Outcome& outcome, const std::string& names) {
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_NE(outcome.err.find(names), std::string::npos);
    EXPECT_LT(outcome.seconds, 5.0);
  }

  std::vector<std::string> files_in(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / name)) {
      names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

TEST_F(Output, MissingFolder) {
  for (const std::string file : {"none/a.csv", "none/a.png"}) {
    const std::string command = file.ends_with("png") ? "render" : "plant";
    expect_failure(testing::prairie({command, scene_, "-o", (folder_ / file).string()}), "none");
  }
}

TEST_F(Output, FolderThatTakesNoFiles) {
  // Also root may not write here.
  expect_failure(testing::prairie({"plant", scene_, "-o", "/proc/a.csv"}), "/proc");
  expect_failure(testing::prairie({"new", "/proc/scene"}), "/proc/scene");
}

TEST_F(Output, FolderOrDeviceInPlaceOfAFile) {
  fs::create_directory(folder_ / "a.csv");
  expect_failure(testing::prairie({"plant", scene_, "-o", (folder_ / "a.csv").string()}), "a.csv");
  fs::create_symlink("/dev/null", folder_ / "b.csv");
  expect_failure(testing::prairie({"plant", scene_, "-o", (folder_ / "b.csv").string()}), "b.csv");
}

TEST_F(Output, FullStdout) {
  Call call;
  call.program = "/bin/sh";
  call.arguments = {"-c", std::string(PRAIRIE_PROGRAM) + " plant " + scene_ + " -o - > /dev/full"};
  expect_failure(testing::run(call), "standard output");
}

TEST_F(Output, LimitOnFileSizeLeavesNothingBehind) {
  fs::create_directory(folder_ / "out");
  testing::write_text(folder_ / "out" / "a.csv", "before");
  Call call;
  call.arguments = {"plant", scene_, "-o", (folder_ / "out" / "a.csv").string()};
  call.before_start = [] {
    const rlimit limit{64 << 10, 64 << 10};
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);
  };
  expect_failure(testing::run(call), "a.csv");
  EXPECT_EQ(files_in("out"), std::vector<std::string>{"a.csv"});
  EXPECT_EQ(fs::file_size(folder_ / "out" / "a.csv"), 6u);
}

TEST_F(Output, FullDisk) {
  fs::create_directory(folder_ / "disk");
  const std::string disk = (folder_ / "disk").string();
  for (const std::string& arguments :
       {"plant " + scene_ + " -o " + disk + "/a.csv",
        "plant " + scene_ + " --set species.0.density=5000.0 -o " + disk + "/a.ply",
        "new " + disk + "/scene --height " + (folder_ / "large.tif").string() + " --spacing 1"}) {
    if (arguments.starts_with("new")) {
      std::vector<float> heights(800 * 800);
      std::mt19937 noise;  // which no compression makes small
      for (float& height_m : heights) height_m = static_cast<float>(noise() % 65521);
      testing::write_image(folder_ / "large.tif", 800, 800, 1, OIIO::TypeDesc::FLOAT, heights);
    }
    Call call;
    call.program = "unshare";
    // A disk of 1 MB that only this process sees, with files on it that must survive.
    call.arguments = {geteuid() == 0 ? "-m" : "-rm", "sh", "-c",
                      "mount -t tmpfs -o size=1m none " + disk + " || exit 99; head -c 700000 /dev/zero > " +
                          disk + "/a.csv; " + PRAIRIE_PROGRAM + " " + arguments + "; code=$?; wc -c < " +
                          disk + "/a.csv; ls -A " + disk + " | grep -c part; exit $code"};
    const Outcome outcome = testing::run(call);
    if (outcome.exit_code == 99 || outcome.err.find("unshare failed") != std::string::npos) {
      GTEST_SKIP() << "no disk of its own may be mounted here: " << outcome.err;
    }
    SCOPED_TRACE(arguments);
    expect_failure(outcome, disk);
    EXPECT_EQ(outcome.out, "700000\n0\n");
  }
}

TEST_F(Output, InterruptedLeavesNothingBehind) {
  fs::create_directory(folder_ / "out");
  testing::write_text(folder_ / "out" / "a.csv", "before");
  for (const int signal_number : {SIGINT, SIGTERM}) {
    Call call;
    call.arguments = {
        "plant", scene_, "-o", (folder_ / "out" / "a.csv").string(), "--set", "species.0.density=50000.0"};
    testing::Running running(call);
    for (int wait = 0; wait < 500 && files_in("out").size() < 2; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(files_in("out").size(), 2u) << "the temporary file";
    kill(running.process(), signal_number);
    EXPECT_EQ(running.finish().exit_code, 128 + signal_number);
    EXPECT_EQ(files_in("out"), std::vector<std::string>{"a.csv"});
    EXPECT_EQ(fs::file_size(folder_ / "out" / "a.csv"), 6u);
  }
}

}  // namespace
}  // namespace prairie
