// ./run as the way to the program: from any folder, with the caller's paths and the program's stdout and exit
// code.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Call;
using testing::Outcome;

class RunScript : public ::testing::Test {
 protected:
  RunScript() { testing::write_small_scene(folder_ / "scene"); }

  Call call(const std::vector<std::string>& arguments) const {
    Call result;
    result.program = PRAIRIE_RUN_SCRIPT;
    result.folder = folder_.path();
    result.arguments = arguments;
    return result;
  }

  const TemporaryFolder folder_;
};

TEST_F(RunScript, PassesStdoutAndExitCodeOn) {
  const Outcome direct =
      testing::prairie({"plant", (folder_ / "scene").string(), "--hashes", "-o", "-", "-q"});
  const Outcome passed = testing::run(call({"plant", "scene", "--hashes", "-o", "-", "-q"}));
  EXPECT_EQ(passed.exit_code, 0) << passed.err;
  EXPECT_EQ(passed.out, direct.out);
  EXPECT_EQ(passed.err, "");
  EXPECT_EQ(testing::run(call({"info", "no such scene"})).exit_code, 3);
  EXPECT_EQ(testing::run(call({"rendr"})).exit_code, 2);
}

TEST_F(RunScript, PathsAreTheCallersAlsoThroughALink) {
  fs::create_symlink(PRAIRIE_RUN_SCRIPT, folder_ / "prairie link");
  Call linked = call({"plant", "scene", "-o", "my blades.csv", "-q"});
  linked.program = folder_ / "prairie link";
  const Outcome outcome = testing::run(linked);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder_ / "my blades.csv"));
}

TEST_F(RunScript, ASecondRunRebuildsNothingAndIsQuick) {
  const auto built = fs::last_write_time(PRAIRIE_PROGRAM);
  const Outcome outcome = testing::run(call({"--version"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(fs::last_write_time(PRAIRIE_PROGRAM), built);
  EXPECT_LT(outcome.seconds, 5.0);
}

TEST_F(RunScript, TwoAtTheSameTime) {
  testing::Running first(call({"--version"}));
  testing::Running second(call({"--version"}));
  const Outcome one = first.finish();
  const Outcome other = second.finish();
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, other.out);
}

}  // namespace
}  // namespace prairie
