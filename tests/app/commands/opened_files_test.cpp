// What the program opens, as the system's own tracer sees it: the scene's files and those of the system,
// never another person's, and no socket.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "tests/app/commands/program.h"
#include "tests/maps/test_images.h"
#include "tests/maps/test_rasters.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

/// A mosaic that leads to that file.
std::string mosaic_of(const std::string& source) {
  return R"(<VRTDataset rasterXSize="40" rasterYSize="30"><GeoTransform>0,1,0,30,0,-1</GeoTransform>)"
         R"(<VRTRasterBand dataType="Float32" band="1"><SimpleSource>)" +
         source + "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
}

struct Trace {
  int exit_code = -1;
  std::vector<std::string> opened;  // absolute
  int sockets = 0;
};

/// Of `prairie info FOLDER`.
Trace trace_of(const fs::path& scene, const fs::path& log) {
  const testing::Outcome outcome =
      testing::run({.arguments = {"-f", "-qq", "-e", "trace=openat,open,openat2,socket", "-o", log.string(),
                                  PRAIRIE_PROGRAM, "info", "."},
                    .folder = scene,
                    .program = "/usr/bin/strace"});
  Trace trace;
  trace.exit_code = outcome.exit_code;
  const std::regex open_call(R"re(open(?:at2?)?\((?:AT_FDCWD, )?"([^"]*)".* = \d+)re");
  std::ifstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, open_call))
      trace.opened.push_back((scene / match[1].str()).lexically_normal().string());
    if (line.find(" socket(") != std::string::npos || line.starts_with("socket(")) ++trace.sockets;
  }
  return trace;
}

TEST(OpenedFiles, AreTheScenesAndTheSystems) {
  if (std::system("strace -qq -e trace=none true >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "strace is not installed, or may not trace here";
  const TemporaryFolder folder;
  const fs::path scene = folder / "scene";
  fs::create_directories(scene);
  testing::RasterPlan plan;
  plan.place = testing::north_up(1.0, 0.0, 0.0, plan.rows);
  for (const fs::path& file : {scene / "h.tif", folder / "secret.tif"})
    testing::write_georaster(file, plan, [](int column, int row, int) { return column + row; });
  const std::string secret = (folder / "secret.tif").string();
  struct Case {
    std::string file;
    int exit_code;
  };
  std::vector<Case> cases{{"h.tif", 0}, {"inside.vrt", 0}};
  testing::write_text(scene / "inside.vrt",
                      mosaic_of(R"(<SourceFilename relativeToVRT="1">h.tif</SourceFilename>)"));
  const std::array ways{
      fmt::format("<SourceFilename>{}</SourceFilename>", secret),
      std::string(R"(<SourceFilename relativeToVRT="1">../secret.tif</SourceFilename>)"),
      std::string("<SourceFilename>/vsicurl/http://127.0.0.1:9/a.tif</SourceFilename>"),
      fmt::format(
          R"(<SourceFilename relativeToVRT="1">h.tif</SourceFilename><OpenOptions><OOI key="X">{}</OOI>)"
          "</OpenOptions>",
          secret),
  };
  for (std::size_t k = 0; k < ways.size(); ++k) {
    cases.push_back({fmt::format("way{}.vrt", k), 3});
    testing::write_text(scene / cases.back().file, mosaic_of(ways[k]));
  }
  for (const Case& each : cases) {
    testing::write_text(
        scene / "scene.toml",
        fmt::format("version = 1\n[height]\nfile = \"{}\"\n[[species]]\nname = \"a\"\n", each.file));
    const Trace trace = trace_of(scene, folder / "trace");
    EXPECT_EQ(trace.exit_code, each.exit_code) << each.file;
    EXPECT_EQ(trace.sockets, 0) << each.file;
    EXPECT_TRUE(std::ranges::find(trace.opened, (scene / each.file).string()) != trace.opened.end());
    for (const std::string& path : trace.opened) {
      const auto lies_in = [&path](const std::string& place) { return path.starts_with(place + "/"); };
      const std::array system{"/usr", "/lib", "/lib64", "/etc", "/proc", "/sys", "/dev"};
      EXPECT_TRUE(lies_in(scene.string()) || path == scene.string() || std::ranges::any_of(system, lies_in))
          << each.file << " has " << path << " opened";
    }
  }
}

}  // namespace
}  // namespace prairie
