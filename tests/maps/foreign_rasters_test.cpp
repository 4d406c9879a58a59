// Georeferenced rasters as surveys, satellites and GIS write them mean what their makers meant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "files/error.h"
#include "maps/georaster/spatial_reference.h"
#include "maps/height_field.h"
#include "maps/map_file.h"
#include "tests/maps/test_images.h"
#include "tests/maps/test_rasters.h"

namespace prairie {
namespace {

using testing::north_up;
using testing::RasterPlan;
using testing::write_georaster;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;
constexpr double kWest = 500'000.0, kSouth = 4'500'000.0;

class ForeignRasters : public ::testing::Test {
 protected:
  MapSpec spec(const std::string& name) const {
    MapSpec result;
    result.file = folder_ / name;
    result.field = "height.file";
    return result;
  }
  Map heights(const MapSpec& spec) const { return read_map(spec, MapMeaning::kHeight, kBudget); }
  std::string refusal(const MapSpec& spec) const {
    try {
      heights(spec);
    } catch (const BadInput& fault) {
      return fault.what();
    }
    return "was read";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
  static bool warns_of(const Map& map, const std::string& part) {
    return std::ranges::any_of(map.warnings, [&](const Warning& warning) { return has(warning.text, part); });
  }
  RasterPlan utm() const {
    RasterPlan plan;
    plan.place = north_up(1.0, kWest, kSouth, plan.rows);
    plan.system = "EPSG:32614";
    return plan;
  }
  /// Row counted from the south.
  static float node(const Map& map, int column, int row) {
    std::vector<float> value(1);
    map.grid.read_block({column, row, 1, 1}, value);
    return value[0];
  }

  TemporaryFolder folder_;
};

double by_place(int column, int row, int) {
  return 100.0 + column + 2.0 * row;
}

TEST_F(ForeignRasters, PackedIntegersAreUnpacked) {
  RasterPlan plan = utm();
  plan.type = "Int16";
  plan.scale_offset = {{0.01, 100.0}};
  write_georaster(folder_ / "h.tif", plan, [](int column, int, int) { return 451 + column; });
  MapSpec packed = spec("h.tif");
  EXPECT_FLOAT_EQ(node(heights(packed), 0, 0), 104.51f);
  packed.range = {{0.0, 32767.0}};
  EXPECT_FLOAT_EQ(node(heights(packed), 0, 0), 104.51f) << "a range of the stored integers changes nothing";

  plan.scale_offset = {{0.0001, 0.0}};
  write_georaster(folder_ / "ndvi.tif", plan, [](int column, int, int) { return 2000 + 150 * column; });
  MapSpec ndvi = spec("ndvi.tif");
  ndvi.range = {{0.2, 0.8}};
  ndvi.max = 100.0;
  const Map density = read_map(ndvi, MapMeaning::kDensity, kBudget);
  EXPECT_NEAR(node(density, 20, 3), 50.0f, 1e-3f);
  EXPECT_FALSE(warns_of(density, "clamped"));
}

TEST_F(ForeignRasters, MasksInsideAndBesideAreGaps) {
  RasterPlan plan = utm();
  plan.has_mask = true;
  plan.is_valid = [](int column, int row) { return column >= 10 || row >= 10; };
  const auto value = [&](int column, int row, int) { return plan.is_valid(column, row) ? 5.0 : 0.0; };
  write_georaster(folder_ / "mask.tif", plan, value);
  plan.mask_is_beside = true;
  write_georaster(folder_ / "beside.tif", plan, value);
  ASSERT_TRUE(std::filesystem::exists(folder_ / "beside.tif.msk"));
  for (const char* name : {"mask.tif", "beside.tif"}) {
    const Map map = heights(spec(name));
    EXPECT_TRUE(std::isnan(node(map, 5, plan.rows - 1))) << name;
    EXPECT_EQ(node(map, 5, 5), 5.0f) << name;
    const HeightField ground(map.grid);
    EXPECT_EQ(ground.range().min_m, 5.0f) << name << ": no pit";
    EXPECT_FALSE(ground.has_data({0.0, 20.5}, {8.0, 28.0})) << name;
  }
  std::filesystem::remove(folder_ / "beside.tif.msk");
  EXPECT_EQ(node(heights(spec("beside.tif")), 5, plan.rows - 1), 0.0f);
}

TEST_F(ForeignRasters, HeightsInFeetBecomeMetres) {
  RasterPlan plan = utm();
  plan.system = "EPSG:6343+6360";  // UTM 14N in metres, heights in US survey feet
  write_georaster(folder_ / "compound.tif", plan, by_place);
  EXPECT_NEAR(node(heights(spec("compound.tif")), 0, plan.rows - 1), 100.0 * 1200.0 / 3937.0, 1e-5);
  plan.system = "EPSG:32614";
  plan.unit = "ft";
  write_georaster(folder_ / "unit.tif", plan, by_place);
  EXPECT_NEAR(node(heights(spec("unit.tif")), 0, plan.rows - 1), 30.48, 1e-5);
  plan.unit = "degrees C";
  write_georaster(folder_ / "warm.tif", plan, by_place);
  EXPECT_TRUE(has(refusal(spec("warm.tif")), "degrees C"));
}

TEST_F(ForeignRasters, FeetByTheSystemsCodeAloneAreFeet) {
  testing::write_geotiff(folder_ / "feet.tif", 64, 64,
                         {.pixel_scale = {5, 5, 0},
                          .tie_points = {0, 0, 0, 1'450'000, 550'000, 0},
                          .keys = {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2264}});
  const Map map = heights(spec("feet.tif"));
  EXPECT_NEAR(map.grid.frame().far_corner_m().x, 63 * 5 * 0.3048, 3.0);
  EXPECT_TRUE(warns_of(map, "resampled"));
  EXPECT_EQ(SpatialReference::of_wkt(map.geo_reference->wkt)->epsg(), 32617);
}

TEST_F(ForeignRasters, WebMercatorIsAsLargeAsTheGround) {
  RasterPlan plan;
  plan.place = north_up(1.0, 1'000'000.0, 6'800'000.0, plan.rows);  // 52° north
  plan.system = "EPSG:3857";
  write_georaster(folder_ / "web.tif", plan, by_place);
  const Map map = heights(spec("web.tif"));
  EXPECT_NEAR(map.grid.frame().spacing_m, 0.617, 0.005);
  EXPECT_NEAR(map.grid.frame().far_corner_m().x, 39 * 0.617, 1.0);
}

TEST_F(ForeignRasters, SouthUpIsTurnedTheRightWayUp) {
  RasterPlan plan = utm();
  plan.place = MapFromPixel{kWest, 1.0, 0.0, kSouth, 0.0, 1.0};
  write_georaster(folder_ / "south.tif", plan, by_place);
  MapSpec south = spec("south.tif");
  for (int times = 0; times < 2; ++times, south.spacing_m = 1.0) {
    const Map map = heights(south);
    EXPECT_EQ(node(map, 3, 7), 100.0f + 3.0f + 14.0f);
    EXPECT_EQ(map.geo_reference->south_m, kSouth + 0.5);
    EXPECT_EQ(map.geo_reference->west_m, kWest + 0.5);
  }
}

TEST_F(ForeignRasters, AQuarterTurnNeedsNoResampling) {
  RasterPlan plan = utm();
  plan.place = testing::turned(north_up(1.0, kWest, kSouth, plan.rows), 0.5 * std::numbers::pi);
  write_georaster(folder_ / "turned.tif", plan, by_place);
  const Map map = heights(spec("turned.tif"));
  // Columns run north, rows east.
  EXPECT_NEAR(map.geo_reference->west_m, kWest + 0.5, 1e-6);
  EXPECT_NEAR(map.geo_reference->south_m, kSouth + plan.rows + 0.5, 1e-6);
  EXPECT_NEAR(node(map, 4, 6), by_place(6, 4, 0), 1e-3);
}

TEST_F(ForeignRasters, CustomaryVoidsOfSurveysAreGaps) {
  RasterPlan plan = utm();
  plan.type = "Int16";
  write_georaster(folder_ / "h.tif", plan,
                  [](int column, int row, int) { return column < 4 && row < 4 ? -32768 : 48; });
  const Map map = heights(spec("h.tif"));
  EXPECT_TRUE(std::isnan(node(map, 0, plan.rows - 1)));
  EXPECT_EQ(HeightField(map.grid).range().min_m, 48.0f);
}

TEST_F(ForeignRasters, EveryNumberTypeOfAGeoTiff) {
  for (const char* type : {"Byte", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64"}) {
    RasterPlan plan = utm();
    plan.type = type;
    write_georaster(folder_ / "h.tif", plan, by_place);
    EXPECT_EQ(node(heights(spec("h.tif")), 7, 5), 100.0f + 7.0f + 2.0f * 24.0f) << type;
  }
  RasterPlan plan = utm();
  plan.type = "CFloat32";
  write_georaster(folder_ / "h.tif", plan, by_place);
  EXPECT_TRUE(has(refusal(spec("h.tif")), "gdal_translate"));
}

TEST_F(ForeignRasters, SparseBlocksAreNodata) {
  RasterPlan plan = utm();
  plan.columns = plan.rows = 64;
  plan.place = north_up(1.0, kWest, kSouth, 64);
  plan.options = {"SPARSE_OK=TRUE", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"};
  plan.nodata = -9999.0;
  write_georaster(folder_ / "sparse.tif", plan,
                  [](int column, int, int) { return column < 32 ? -9999.0 : 3.0; });
  const Map map = heights(spec("sparse.tif"));
  EXPECT_TRUE(std::isnan(node(map, 3, 3)));
  EXPECT_EQ(node(map, 40, 3), 3.0f);
}

TEST_F(ForeignRasters, EsriGridsWithAndWithoutNodata) {
  const std::string head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 2\n";
  testing::write_text(folder_ / "a.asc", head + "NODATA_value -1\n1 2 3\n4 -1 6.5\n");
  testing::write_text(folder_ / "b.asc", head + "1 2 3\n4 5 6.5\n");
  const Map with = heights(spec("a.asc")), without = heights(spec("b.asc"));
  EXPECT_EQ(with.grid.frame().spacing_m, 2.0);
  EXPECT_EQ(with.geo_reference->west_m, 101.0);
  EXPECT_EQ(node(with, 2, 0), 6.5f);
  EXPECT_TRUE(std::isnan(node(with, 1, 0)));
  EXPECT_EQ(node(without, 1, 0), 5.0f);
  EXPECT_EQ(node(without, 0, 1), 1.0f);
}

TEST_F(ForeignRasters, ShuttleTilesKnowTheirPlaceByTheirName) {
  constexpr int kSide = 1201;
  std::string bytes;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const int height = row == 600 && column == 600 ? -32768 : 300 + column / 4;
      bytes.push_back(static_cast<char>((height >> 8) & 0xff));
      bytes.push_back(static_cast<char>(height & 0xff));
    }
  }
  testing::write_text(folder_ / "N45E014.hgt", bytes);
  const Map map = heights(spec("N45E014.hgt"));
  EXPECT_EQ(SpatialReference::of_wkt(map.geo_reference->wkt)->epsg(), 32633);
  EXPECT_NEAR(map.grid.frame().spacing_m, 78.5, 15.0) << "between a third of an arc minute's two sides";
  const HeightField ground(map.grid);
  EXPECT_GE(ground.range().min_m, 299.0f);
  EXPECT_LE(ground.range().max_m, 601.0f);
}

TEST_F(ForeignRasters, BandsAreCountedFromOne) {
  RasterPlan plan = utm();
  plan.bands = 6;
  plan.type = "Byte";
  write_georaster(folder_ / "six.tif", plan, [](int, int, int band) { return 40.0 * (band + 1); });
  MapSpec six = spec("six.tif");
  EXPECT_TRUE(has(refusal(six), "`channel`"));
  for (const char* name : {"4", "band 4", "Band_4"}) {
    six.channel = name;
    EXPECT_EQ(node(heights(six), 1, 1), 160.0f) << name;
  }
  for (const char* name : {"R", "channel4", "0", "7", "-1", "4.5", ""}) {
    six.channel = name;
    EXPECT_TRUE(has(refusal(six), "1 to 6")) << name << ": " << refusal(six);
  }
}

TEST_F(ForeignRasters, WhatLiesInAnotherZoneComesIntoTheScenes) {
  RasterPlan plan;
  plan.place = north_up(1.0, 737'000.0, 5'100'000.0, plan.rows);  // 18° east of the 33rd zone's east
  plan.system = "EPSG:32633";
  write_georaster(folder_ / "a.tif", plan, by_place);
  GeoReference scene;
  scene.wkt = SpatialReference::of_name("EPSG:32634")->wkt();
  const Map map = read_map(spec("a.tif"), MapMeaning::kHeight, kBudget, &scene);
  EXPECT_EQ(SpatialReference::of_wkt(map.geo_reference->wkt)->epsg(), 32634);
  EXPECT_TRUE(warns_of(map, "resampled"));
}

TEST_F(ForeignRasters, AVrtLeadsBelowItsOwnFolderOnly) {
  std::filesystem::create_directories(folder_ / "scene/tiles");
  RasterPlan plan = utm();
  write_georaster(folder_ / "scene/tiles/a.tif", plan, by_place);
  write_georaster(folder_ / "secret.tif", plan, by_place);
  const auto vrt = [&](const std::string& source, const std::string& kind = "SimpleSource",
                       const std::string& band = "") {
    testing::write_text(folder_ / "scene/x.vrt",
                        R"(<VRTDataset rasterXSize="40" rasterYSize="30"><SRS>EPSG:32614</SRS>)"
                        "<GeoTransform>500000, 1, 0, 4500030, 0, -1</GeoTransform>"
                        R"(<VRTRasterBand dataType="Float32" band="1" )" +
                            band + "><" + kind + "><SourceFilename " + source +
                            "</SourceFilename><SourceBand>1</SourceBand></" + kind +
                            "></VRTRasterBand></VRTDataset>");
    return spec("scene/x.vrt");
  };
  EXPECT_EQ(node(heights(vrt(R"(relativeToVRT="1">tiles/a.tif)")), 7, 5), 100.0f + 7.0f + 2.0f * 24.0f);
  for (const std::string& source : std::vector<std::string>{
           R"(relativeToVRT="1">../secret.tif)", ">" + (folder_ / "secret.tif").string(),
           ">/vsicurl/http://127.0.0.1/a.tif", R"(relativeToVRT="1">tiles/../../secret.tif)",
           R"(relativeToVRT="1">tiles/missing.tif)", ">GTIFF_DIR:1:tiles/a.tif"}) {
    EXPECT_NE(refusal(vrt(source)), "was read") << source;
  }
  std::filesystem::create_symlink(folder_ / "secret.tif", folder_ / "scene/tiles/link.tif");
  EXPECT_NE(refusal(vrt(R"(relativeToVRT="1">tiles/link.tif)")), "was read");
  for (const char* kind : {"KernelFilteredSource", "AveragedSource", "ArraySource"})
    EXPECT_NE(refusal(vrt(R"(relativeToVRT="1">tiles/a.tif)", kind)), "was read") << kind;
  for (const char* band : {R"(subClass="VRTRawRasterBand")", R"(subClass="VRTDerivedRasterBand")"})
    EXPECT_NE(refusal(vrt(R"(relativeToVRT="1">tiles/a.tif)", "SimpleSource", band)), "was read") << band;
}

TEST_F(ForeignRasters, TilesOfAFolderAreOneGround) {
  for (const int tile : {0, 1, 2, 3}) {
    RasterPlan plan = utm();
    plan.place = north_up(1.0, kWest + 40.0 * (tile % 2), kSouth + 30.0 * (tile / 2), plan.rows);
    write_georaster(folder_ / ("t" + std::to_string(tile) + ".tif"), plan,
                    [tile](int, int, int) { return 10.0 * (tile + 1); });
  }
  MapSpec several = spec("t0.tif");
  for (const char* name : {"t1.tif", "t2.tif", "t3.tif"}) several.more_files.push_back(folder_ / name);
  MapSpec folder = spec("");
  for (const MapSpec& mosaic : {several, folder}) {
    const Map map = heights(mosaic);
    EXPECT_EQ(map.grid.frame().columns, 80);
    EXPECT_EQ(map.grid.frame().rows, 60);
    EXPECT_EQ(node(map, 1, 1), 10.0f);
    EXPECT_EQ(node(map, 79, 1), 20.0f);
    EXPECT_EQ(node(map, 1, 59), 30.0f);
  }
  EXPECT_EQ(heights(several).content_hash, heights(folder).content_hash);
}

}  // namespace
}  // namespace prairie
