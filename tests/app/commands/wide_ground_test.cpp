// Grounds as wide as a satellite's scene: every command's cost follows the map's nodes and what is asked for,
// never the area.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/commands/program.h"
#include "tests/maps/test_images.h"
#include "tests/maps/test_rasters.h"

namespace prairie {
namespace {

using testing::Outcome;

constexpr double kLongestS = 20.0;
constexpr long kBudgetMib = 2048;

void write_ground(const std::filesystem::path& file, int side, double spacing_m) {
  testing::RasterPlan plan;
  plan.columns = plan.rows = side;
  plan.place = testing::north_up(spacing_m, 400'000.0, 5'000'000.0, side);
  plan.system = "EPSG:32633";
  plan.options = {"TILED=YES", "COMPRESS=LZW", "PREDICTOR=3"};
  testing::write_georaster(file, plan, [](int column, int row, int) {
    return 500.0 + 20.0 * std::sin(column / 70.0) + 10.0 * std::cos(row / 50.0);
  });
}

void expect_quick(const Outcome& outcome, double longest_s, const std::string& what) {
  EXPECT_EQ(outcome.exit_code, 0) << what << ": " << outcome.err;
  EXPECT_LT(outcome.seconds, longest_s) << what;
  EXPECT_LT(outcome.largest_memory_mib, kBudgetMib + kBudgetMib / 10) << what;
}

TEST(WideGround, EveryCommandRunsOnceOn150Kilometres) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder / name).string(); };
  write_ground(folder / "wide.tif", 500, 300.0);
  const std::string scene = path("scene");
  testing::write_text(folder / "tracks.csv", "time_s,id,x_m,y_m\n0,1,75000,75000\n1,1,75001.3,75000\n");
  expect_quick(testing::prairie({"new", scene, "--height", path("wide.tif")}), 10.0, "new");
  expect_quick(testing::prairie({"info", scene}), 10.0, "info");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"render", scene, "-o", path("a.png"), "--size", "160x90"},
           {"export", scene, "-o", path("tiles"), "--tiles", "9000,9000,9000,9000", "--size", "64x64",
            "--views", "top"},
           {"plant", scene, "-o", path("blades.csv"), "--tiles", "9000,9000,9000,9000"},
           {"record", scene, "-o", path("clip"), "--duration", "0.05", "--size", "64x64"},
           {"walk", scene, "--replay", path("tracks.csv"), "--duration", "0.5"}})
    expect_quick(testing::prairie(arguments), kLongestS, arguments.front());
}

TEST(WideGroundLongTest, TenKilometresAtAMetreAndAThousandAtAKilometre) {
  const TemporaryFolder folder;
  for (const auto& [side, spacing_m] : {std::pair{10'000, 1.0}, {1000, 1000.0}}) {
    write_ground(folder / "wide.tif", side, spacing_m);
    const std::string scene = (folder / ("scene" + std::to_string(side))).string();
    const Outcome made = testing::prairie({"new", scene, "--height", (folder / "wide.tif").string()});
    const Outcome told = testing::prairie({"info", scene});
    expect_quick(made, kLongestS, "new");
    expect_quick(told, kLongestS, "info");
    RecordProperty("new_s_" + std::to_string(side), std::to_string(made.seconds));
    RecordProperty("info_s_" + std::to_string(side), std::to_string(told.seconds));
  }
}

}  // namespace
}  // namespace prairie
