// Heights against an independent reading: rasters of every number type in every form that surveys give them,
// pixel by pixel as gdallocationinfo tells them (and gdaltransform, where they lie in another system).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <random>

#include "files/error.h"
#include "maps/georaster/spatial_reference.h"
#include "maps/map_file.h"
#include "tests/maps/test_images.h"
#include "tests/maps/test_rasters.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::north_up;
using testing::RasterPlan;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;
constexpr int kPlaces = 1000;
constexpr double kWave_px = 240.0;
constexpr double kMiddle = 100.0, kAmplitude = 60.0;  // of stored values, so that bytes hold them
constexpr double kGone = 7.0;                         // what masked and missing pixels hold

double smooth(int column, int row) {
  const double k = 2.0 * std::numbers::pi / kWave_px;
  return kMiddle + kAmplitude * std::sin(k * column) * std::cos(k * row);
}

bool is_in_hole(int column, int row) {
  return column >= 20 && column < 34 && row >= 40 && row < 55;
}

struct Form {
  const char* name;
  RasterPlan plan;
  double metres_per_unit = 1.0;  // of what the values are after scale and offset
  bool has_hole = false;
  bool is_resampled = false;
  bool is_exact = false;   // though resampled: its pixels lie on the nodes
  int parts = 1;           // 4: a VRT of quarters
  const char* scene = "";  // system of the scene
};

RasterPlan utm_plan() {
  RasterPlan plan;
  plan.columns = 96;
  plan.rows = 80;
  plan.place = north_up(2.0, 500'000.0, 4'500'000.0, plan.rows);
  plan.system = "EPSG:32633";
  return plan;
}

RasterPlan placed(MapFromPixel place, const char* system) {
  RasterPlan plan = utm_plan();
  plan.place = place;
  plan.system = system;
  return plan;
}

RasterPlan with_options(std::vector<std::string> options) {
  RasterPlan plan = utm_plan();
  plan.options = std::move(options);
  return plan;
}

std::vector<Form> forms() {
  const RasterPlan plain = utm_plan();
  constexpr double kDegree = std::numbers::pi / 180.0;
  std::vector<Form> forms{{.name = "plain", .plan = plain}};
  Form form{.name = "scale and offset", .plan = plain};
  form.plan.scale_offset = {{0.125, -40.0}};
  forms.push_back(form);
  form = {.name = "mask", .plan = plain, .has_hole = true};
  form.plan.has_mask = true;
  form.plan.is_valid = [](int column, int row) { return !is_in_hole(column, row); };
  forms.push_back(form);
  form = {.name = "nodata", .plan = plain, .has_hole = true};
  form.plan.nodata = kGone;
  forms.push_back(form);
  form = {.name = "heights in feet", .plan = plain, .metres_per_unit = 0.3048};
  form.plan.unit = "ft";
  forms.push_back(form);
  forms.push_back({.name = "plane in feet",
                   .plan = placed(north_up(5.0, 1'450'000.0, 550'000.0, plain.rows), "EPSG:2264"),
                   .is_resampled = true});
  forms.push_back(
      {.name = "south up", .plan = placed({500'000.0, 2.0, 0.0, 4'500'000.0, 0.0, 2.0}, "EPSG:32633")});
  for (const auto& [name, angle] :
       {std::pair{"turned by 1e-12°", 1e-12}, {"turned by 3°", 3.0}, {"turned by 90°", 90.0}}) {
    forms.push_back({.name = name,
                     .plan = placed(testing::turned(*plain.place, angle * kDegree), "EPSG:32633"),
                     .is_resampled = angle >= 3.0,
                     .is_exact = angle == 90.0});
  }
  forms.push_back({.name = "degrees",
                   .plan = placed({14.5, 2e-5, 0.0, 46.0, 0.0, -2e-5}, "EPSG:4326"),
                   .is_resampled = true});
  forms.push_back({.name = "Web Mercator",
                   .plan = placed(north_up(3.0, 1'600'000.0, 5'800'000.0, plain.rows), "EPSG:3857"),
                   .is_resampled = true});
  forms.push_back({.name = "another zone",
                   .plan = placed(north_up(2.0, 737'000.0, 5'100'000.0, plain.rows), "EPSG:32633"),
                   .is_resampled = true,
                   .scene = "EPSG:32634"});
  forms.push_back({.name = "tiled",
                   .plan = with_options({"TILED=YES", "BLOCKXSIZE=32", "BLOCKYSIZE=16", "COMPRESS=LZW"})});
  form = {.name = "cloud optimised", .plan = with_options({"COMPRESS=DEFLATE"})};
  form.plan.driver = "COG";
  forms.push_back(form);
  forms.push_back({.name = "BigTIFF", .plan = with_options({"BIGTIFF=YES"})});
  forms.push_back({.name = "VRT of four", .plan = plain, .parts = 4});
  form = {.name = "ESRI grid", .plan = with_options({"FORCE_CELLSIZE=YES"})};
  form.plan.driver = "AAIGrid";
  forms.push_back(form);
  form = {
      .name = "SRTM tile",
      .plan = placed({14.0 - 0.5 / 1200, 1.0 / 1200, 0.0, 46.0 + 0.5 / 1200, 0.0, -1.0 / 1200}, "EPSG:4326"),
      .is_resampled = true};
  form.plan.driver = "SRTMHGT";
  form.plan.columns = form.plan.rows = 1201;
  forms.push_back(form);
  return forms;
}

/// Lines that a program prints, told by lines.
std::vector<std::string> answers(const TemporaryFolder& folder, const std::string& command,
                                 const std::string& questions) {
  testing::write_text(folder / "questions", questions);
  const fs::path out = folder / "answers";
  const std::string line = fmt::format("{} <'{}' >'{}' 2>'{}'", command, (folder / "questions").string(),
                                       out.string(), (folder / "complaints").string());
  std::vector<std::string> result;
  if (std::system(line.c_str()) != 0) {
    ADD_FAILURE() << line;
    return result;
  }
  std::ifstream stream(out);
  for (std::string text; std::getline(stream, text);) result.push_back(text);
  return result;
}

class RasterMatrix : public ::testing::TestWithParam<Form> {
 protected:
  void SetUp() override {
    if (std::system("gdallocationinfo --version >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "gdallocationinfo (gdal-bin) is not installed";
  }

  fs::path write(const RasterPlan& plan, bool has_hole) const {
    const auto value = [&](int column, int row, int) {
      if (has_hole && is_in_hole(column, row)) return kGone;
      return plan.type.starts_with("Float") ? smooth(column, row) : std::round(smooth(column, row));
    };
    const fs::path file = folder_ / (plan.driver == "AAIGrid"   ? "h.asc"
                                     : plan.driver == "SRTMHGT" ? "N45E014.hgt"
                                                                : "h.tif");
    write_georaster(file, plan, value);
    return file;
  }

  /// Quarters and a VRT that joins them.
  fs::path write_quarters(const RasterPlan& whole) const {
    std::string sources;
    for (int part = 0; part < 4; ++part) {
      RasterPlan plan = whole;
      plan.columns /= 2;
      plan.rows /= 2;
      const int x = part % 2 * plan.columns, y = part / 2 * plan.rows;
      (*plan.place)[0] += x * (*plan.place)[1];
      (*plan.place)[3] += y * (*plan.place)[5];
      write_georaster(folder_ / fmt::format("part{}.tif", part), plan, [&](int column, int row, int) {
        const double value = smooth(column + x, row + y);
        return plan.type.starts_with("Float") ? value : std::round(value);
      });
      sources += fmt::format("'{}' ", (folder_ / fmt::format("part{}.tif", part)).string());
    }
    const fs::path file = folder_ / "h.vrt";
    EXPECT_EQ(std::system(fmt::format("gdalbuildvrt -q '{}' {}", file.string(), sources).c_str()), 0);
    return file;
  }

  /// Places of pixels in the scene's system.
  std::vector<glm::dvec2> places(const Form& form, const std::vector<std::array<int, 2>>& pixels,
                                 const GeoReference& scene) const {
    const MapFromPixel& map = *form.plan.place;
    std::vector<glm::dvec2> result;
    std::string questions;
    for (const auto& [column, row] : pixels) {
      const double x = column + 0.5, y = row + 0.5;
      result.emplace_back(map[0] + x * map[1] + y * map[2], map[3] + x * map[4] + y * map[5]);
      questions += fmt::format("{:.17g} {:.17g}\n", result.back().x, result.back().y);
    }
    const std::string system = fmt::format("EPSG:{}", *SpatialReference::of_wkt(scene.wkt)->epsg());
    if (system == form.plan.system) return result;
    const auto lines = answers(
        folder_, fmt::format("gdaltransform -s_srs {} -t_srs {}", form.plan.system, system), questions);
    for (std::size_t k = 0; k < result.size(); ++k)
      EXPECT_EQ(std::sscanf(lines.at(k).c_str(), "%lf %lf", &result[k].x, &result[k].y), 2);
    return result;
  }

  TemporaryFolder folder_;
};

TEST_P(RasterMatrix, HeightsAreThoseOfAnIndependentReading) {
  const Form& form = GetParam();
  int read = 0;
  for (const char* type : {"Byte", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64"}) {
    SCOPED_TRACE(type);
    RasterPlan plan = form.plan;
    plan.type = type;
    // What these formats can hold.
    if (plan.driver == "SRTMHGT" && plan.type != "Int16") continue;
    if (plan.driver == "AAIGrid" && (plan.type == "UInt32" || plan.type == "Float64")) continue;
    const fs::path file = form.parts == 4 ? write_quarters(plan) : write(plan, form.has_hole);
    MapSpec spec;
    spec.file = file;
    spec.field = "height.file";
    GeoReference scene;
    if (*form.scene != '\0') scene.wkt = SpatialReference::of_name(form.scene)->wkt();
    const Map map = read_map(spec, MapMeaning::kHeight, kBudget, *form.scene != '\0' ? &scene : nullptr);
    ASSERT_TRUE(map.geo_reference);

    std::mt19937 random(5);
    std::vector<std::array<int, 2>> pixels;
    std::string questions;
    for (int k = 0; k < kPlaces; ++k) {
      // Resampling needs the pixels around; those of the border have none.
      const int margin = form.is_resampled ? 3 : 0;
      const auto within = [&](int count) {
        return margin + static_cast<int>(random() % static_cast<unsigned>(count - 2 * margin));
      };
      pixels.push_back({within(plan.columns), within(plan.rows)});
      questions += fmt::format("{} {}\n", pixels.back()[0], pixels.back()[1]);
    }
    const auto told =
        answers(folder_, fmt::format("gdallocationinfo -valonly '{}'", file.string()), questions);
    ASSERT_EQ(told.size(), pixels.size());
    const std::vector<glm::dvec2> where = places(form, pixels, *map.geo_reference);
    const auto [scale, offset] = plan.scale_offset.value_or(std::array{1.0, 0.0});
    const double relief_m = 2.0 * kAmplitude * scale * form.metres_per_unit;
    double allowed_m = 1e-4 * relief_m;
    if (form.is_resampled && !form.is_exact) {
      // Twice the error of a bilinear patch of the ground's greatest curvature, for a stretch of pixels up to
      // 1.5; integers jump by one.
      const double bend = std::pow(1.5 * 2.0 * std::numbers::pi / kWave_px, 2.0);
      allowed_m += 2.0 * 0.25 * bend * kAmplitude;
      if (!plan.type.starts_with("Float")) allowed_m += 1.0;
    }
    double worst_m = 0.0;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const glm::dvec2 place_m = where[k] - glm::dvec2(map.geo_reference->west_m, map.geo_reference->south_m);
      const double height_m = static_cast<double>(map.grid.sample(place_m));
      if (form.has_hole && is_in_hole(pixels[k][0], pixels[k][1])) {
        EXPECT_TRUE(std::isnan(height_m)) << pixels[k][0] << ", " << pixels[k][1];
        continue;
      }
      const double expected_m = (std::stod(told[k]) * scale + offset) * form.metres_per_unit;
      worst_m = std::max(worst_m, std::isnan(height_m) ? 1e9 : std::abs(height_m - expected_m));
    }
    EXPECT_LE(worst_m, allowed_m) << "of a relief of " << relief_m << " m";
    RecordProperty(fmt::format("worst_share_{}", type), fmt::format("{:.2e}", worst_m / relief_m));
    const bool says_so = std::ranges::any_of(map.warnings, [](const Warning& warning) {
      return warning.text.find("resampled") != std::string::npos;
    });
    EXPECT_EQ(says_so, form.is_resampled);
    ++read;
  }
  EXPECT_GT(read, 0);
}

INSTANTIATE_TEST_SUITE_P(Forms, RasterMatrix, ::testing::ValuesIn(forms()),
                         [](const ::testing::TestParamInfo<Form>& form) {
                           std::string name = form.param.name;
                           std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

}  // namespace
}  // namespace prairie
