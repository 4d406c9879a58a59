// The commands that draw: pictures of the right size and kind, tile screenshots with a true manifest, the
// viewer in a window that nobody looks at, and drivers that cannot do it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "app/sha256.h"
#include "tests/app/program.h"
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

  const testing::TemporaryFolder folder_;
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
                         const std::map<std::string, std::string>& environment, const fs::path& code_file) {
  Call call;
  call.program = "xvfb-run";
  call.arguments = {"-a", "sh", "-c", "\"$@\"; echo $? >\"$0\"", code_file.string(), PRAIRIE_PROGRAM};
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

TEST_F(Pictures, ViewUnderAnOldDriverEndsWithFour) {
  const Outcome outcome = in_hidden_window({"view", scene_, "--frames", "1"},
                                           {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}, folder_ / "exit_code");
  if (outcome.exit_code == 127) GTEST_SKIP() << "xvfb-run is not installed";
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
}

}  // namespace
}  // namespace prairie
