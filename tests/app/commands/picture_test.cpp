// The commands that draw: pictures of the right size and kind, tile screenshots with a true manifest, the
// viewer in a window that nobody looks at, and drivers that cannot do it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "files/sha256.h"
#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Call;
using testing::Outcome;

class Pictures : public ::testing::Test {
 protected:
  Pictures() { testing::write_small_scene(folder_ / "scene"); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Outcome with_environment(const std::vector<std::string>& arguments,
                           const std::map<std::string, std::string>& environment) const {
    Call call;
    call.arguments = arguments;
    call.environment = environment;
    return testing::run(call);
  }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

TEST_F(Pictures, RenderWritesPngAndExr) {
  for (const std::string name : {"a.png", "a.exr"}) {
    const Outcome outcome =
        testing::prairie({"render", scene_, "-o", path(name), "--size", "96x64", "--samples", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const auto input = OIIO::ImageInput::open(path(name));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 96);
    EXPECT_EQ(input->spec().height, 64);
    EXPECT_EQ(input->spec().nchannels, 3);
    EXPECT_EQ(input->spec().format.basetype, name == "a.png" ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  }
}

TEST_F(Pictures, RenderTakesTheSmallestAndTheWidest) {
  for (const glm::ivec2 size_px : {glm::ivec2(1, 1), glm::ivec2(16384, 64), glm::ivec2(3, 16384)}) {
    const std::string size = fmt::format("{}x{}", size_px.x, size_px.y);
    const Outcome outcome = testing::prairie({"render", scene_, "-o", path("a.png"), "--size", size});
    ASSERT_EQ(outcome.exit_code, 0) << size << ": " << outcome.err;
    const auto input = OIIO::ImageInput::open(path("a.png"));
    ASSERT_TRUE(input) << size;
    EXPECT_EQ(input->spec().width, size_px.x);
    EXPECT_EQ(input->spec().height, size_px.y);
  }
}

TEST_F(Pictures, ALostContextLeavesNoPicture) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"render", scene_, "-o", path("a.png"), "--size", "64x48"},
        std::vector<std::string>{"export", scene_, "-o", path("tiles"), "--size", "64x48"}}) {
    testing::write_text(path("a.png"), "before");
    Call call;
    call.program = PRAIRIE_PROGRAM_WITH_RESETS;
    call.arguments = arguments;
    call.environment = {{"PRAIRIE_TEST_RESETS", "1-1"}};
    const Outcome outcome = testing::run(call);
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_NE(outcome.err.find("a reset of the graphics device"), std::string::npos);
    EXPECT_NE(outcome.err.find("try "), std::string::npos);
    EXPECT_EQ(fs::file_size(path("a.png")), 6u);
    EXPECT_FALSE(fs::exists(path("tiles/manifest.json")));
    // The same program, when nothing happens.
    call.environment = {};
    EXPECT_EQ(testing::run(call).exit_code, 0);
  }
}

TEST_F(Pictures, EveryTierAndATypedCamera) {
  std::set<std::string> pictures;
  for (const std::string tier : {"hermite", "flat"}) {
    const Outcome outcome = testing::prairie({"render", scene_, "-o", path(tier + ".png"), "--size", "96x64",
                                              "--tier", tier, "--camera", "8,2,+0.8,0,-20,70"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    pictures.insert(sha256_hex(testing::read_bytes(path(tier + ".png"))));
  }
  EXPECT_EQ(pictures.size(), 2u);
}

TEST_F(Pictures, ExportIsCompleteAndTheSameEveryTime) {
  const auto export_to = [&](const std::string& name) {
    return testing::prairie({"export", scene_, "-o", path(name), "--tiles", "1,1,2,1", "--views", "eye,top",
                             "--tiers", "hermite,flat", "--size", "64x48"});
  };
  const Outcome outcome = export_to("one");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  ASSERT_EQ(export_to("two/deeper").exit_code, 0);

  std::ifstream file(path("one/manifest.json"));
  const nlohmann::json manifest = nlohmann::json::parse(file);
  EXPECT_EQ(manifest["seed"], 5);
  EXPECT_EQ(manifest["files"].size(), 2u * 2u * 2u);
  EXPECT_EQ(manifest.dump().find(folder_.path().string()), std::string::npos) << "an absolute path";
  for (const nlohmann::json& entry : manifest["files"]) {
    const std::string name = entry["file"];
    const std::vector<std::byte> bytes = testing::read_bytes(path("one/" + name));
    EXPECT_EQ(entry["sha256"], sha256_hex(bytes)) << name;
    EXPECT_GT(entry["blades_planted"].get<int>(), 0) << name;
    EXPECT_EQ(bytes, testing::read_bytes(path("two/deeper/" + name))) << name;
  }
  EXPECT_EQ(testing::read_bytes(path("one/manifest.json")),
            testing::read_bytes(path("two/deeper/manifest.json")));
  EXPECT_TRUE(fs::exists(path("one/tile_2_1_eye_flat.png")));
}

TEST_F(Pictures, DeviceIsChosenByNumberAndListed) {
  const Outcome list = testing::prairie({"--list-devices"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_TRUE(list.out.starts_with("0: ")) << list.out;
  const Outcome wrong =
      testing::prairie({"render", scene_, "-o", path("a.png"), "--device", "no such device"});
  EXPECT_EQ(wrong.exit_code, 4) << wrong.err;
}

TEST_F(Pictures, OldOrMissingOpenGlIsSaidInOneLine) {
  // Mesa alone, so that a machine with another driver is tested like one without.
  const std::map<std::string, std::string> old{
      {"MESA_GL_VERSION_OVERRIDE", "3.3"},
      {"__EGL_VENDOR_LIBRARY_FILENAMES", "/usr/share/glvnd/egl_vendor.d/50_mesa.json"}};
  const std::map<std::string, std::string> none{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}};
  for (const auto& environment : {old, none}) {
    testing::write_text(path("a.png"), "before");
    const Outcome outcome = with_environment({"render", scene_, "-o", path("a.png")}, environment);
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_NE(outcome.err.find("4.5"), std::string::npos);
    EXPECT_LT(outcome.seconds, 5.0);
    EXPECT_LT(outcome.largest_memory_mib, 512);
    EXPECT_EQ(fs::file_size(path("a.png")), 6u);
    EXPECT_EQ(with_environment({"export", scene_, "-o", path("tiles")}, environment).exit_code, 4);
    EXPECT_FALSE(fs::exists(path("tiles")));
  }
}

TEST_F(Pictures, ViewNeedsADisplay) {
  Call call;
  call.arguments = {"view", scene_};
  call.before_start = [] {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  };
  const Outcome outcome = testing::run(call);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("DISPLAY"), std::string::npos) << outcome.err;
}

/// The program with these arguments in a window that nobody looks at; its own exit code, since xvfb-run's
/// tells as well whether it could clean up behind two X servers that end at once.
Outcome in_hidden_window(const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment, const fs::path& code_file,
                         const std::string& program = PRAIRIE_PROGRAM) {
  Call call;
  call.program = "xvfb-run";
  // Without -noreset the server starts anew whenever its last window closes, as during a reset of the device,
  // and refuses who comes just then.
  call.arguments = {"-a",
                    "-s",
                    "-screen 0 1280x1024x24 -noreset",
                    "sh",
                    "-c",
                    "\"$@\"; echo $? >\"$0\"",
                    code_file.string(),
                    program};
  call.arguments.insert(call.arguments.end(), arguments.begin(), arguments.end());
  call.environment = environment;
  Outcome outcome = testing::run(call);
  std::ifstream(code_file) >> outcome.exit_code;
  return outcome;
}

TEST_F(Pictures, ViewShowsAWindow) {
  const Outcome outcome = in_hidden_window(
      {"view", scene_, "--size", "200x150", "--frames", "3", "--screenshot", path("seen.png")}, {},
      folder_ / "exit_code");
  if (outcome.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const auto input = OIIO::ImageInput::open(path("seen.png"));
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().width, 200);
  EXPECT_EQ(input->spec().height, 150);
}

TEST_F(Pictures, ViewTakesTheSmallestAndTheWidestWindow) {
  for (const std::string size : {"1x1", "16384x64"}) {
    const Outcome outcome =
        in_hidden_window({"view", scene_, "--size", size, "--frames", "3"}, {}, folder_ / "exit_code");
    if (outcome.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
    EXPECT_EQ(outcome.exit_code, 0) << size << ": " << outcome.err;
  }
}

TEST_F(Pictures, ViewGoesOnAfterAReset) {
  const auto view = [&](const std::string& resets, const std::string& picture) {
    return in_hidden_window({"view", scene_, "--camera", "8,2,+3,20,-10", "--tier", "hermite", "--size",
                             "200x150", "--frames", "3", "--screenshot", path(picture)},
                            {{"PRAIRIE_TEST_RESETS", resets}}, folder_ / "exit_code",
                            PRAIRIE_PROGRAM_WITH_RESETS);
  };
  // The second frame is lost, and so is the answer to the viewer's first question whether the reset is over.
  const Outcome reset = view("2-3", "after.png");
  if (reset.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
  EXPECT_EQ(reset.exit_code, 0) << reset.err;
  EXPECT_NE(reset.err.find("warning: drawing goes on after a reset of the graphics device"),
            std::string::npos)
      << reset.err;
  const Outcome undisturbed = view("0-0", "before.png");
  EXPECT_EQ(undisturbed.exit_code, 0) << undisturbed.err;
  EXPECT_EQ(undisturbed.err, "");
  EXPECT_EQ(testing::read_bytes(path("after.png")), testing::read_bytes(path("before.png")))
      << "the camera or the tier has changed";
}

TEST_F(Pictures, ViewEndsWhereEveryFrameIsLost) {
  for (const std::string resets : {"1-1000000", "3-1000000"}) {
    const Outcome outcome = in_hidden_window({"view", scene_, "--size", "64x48", "--frames", "9"},
                                             {{"PRAIRIE_TEST_RESETS", resets}}, folder_ / "exit_code",
                                             PRAIRIE_PROGRAM_WITH_RESETS);
    if (outcome.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("prairie: OpenGL: found a reset of the graphics device"), std::string::npos)
        << outcome.err;
  }
}

TEST_F(Pictures, ViewUnderAnOldDriverEndsWithFour) {
  const Outcome outcome = in_hidden_window({"view", scene_, "--frames", "1"},
                                           {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}, folder_ / "exit_code");
  if (outcome.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
}

}  // namespace
}  // namespace prairie
