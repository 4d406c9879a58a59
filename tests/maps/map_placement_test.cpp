#include <gtest/gtest.h>

#include "files/error.h"
#include "maps/map_file.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using testing::GeoTiffTags;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;

class MapPlacement : public ::testing::Test {
 protected:
  MapSpec spec(const std::string& name) const {
    MapSpec result;
    result.file = folder_ / name;
    result.field = "heights.file";
    return result;
  }
  Map read(const MapSpec& spec) const { return read_map(spec, MapMeaning::kHeight, kBudget); }
  std::string refusal(const MapSpec& spec) const {
    try {
      read(spec);
    } catch (const BadInput& fault) {
      return fault.what();
    }
    ADD_FAILURE() << "was read";
    return "";
  }
  bool warns_of(const MapSpec& spec, const std::string& part) const {
    for (const Warning& warning : read(spec).warnings) {
      if (warning.text.find(part) != std::string::npos) return true;
    }
    return false;
  }
  TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(MapPlacement, PixelIsAreaUnlessSaidOtherwise) {
  const GeoTiffTags area{.pixel_scale = {2, 2, 0}, .tie_points = {0, 0, 0, 1000, 5000, 0}};
  testing::write_geotiff(folder_ / "area.tif", 4, 3, area);
  const Map map = read(spec("area.tif"));
  EXPECT_EQ(map.grid.frame().spacing_m, 2.0);
  ASSERT_TRUE(map.geo_reference.has_value());
  EXPECT_EQ(map.geo_reference->west_m, 1001.0);
  EXPECT_EQ(map.geo_reference->south_m, 4995.0);  // the corner 5000, half a pixel and two pixels down
}

TEST_F(MapPlacement, PixelIsPointTiesTheCentre) {
  const GeoTiffTags point{
      .pixel_scale = {2, 2, 0}, .tie_points = {0, 0, 0, 1000, 5000, 0}, .keys = {1, 1, 0, 1, 1025, 0, 1, 2}};
  testing::write_geotiff(folder_ / "point.tif", 4, 3, point);
  const Map map = read(spec("point.tif"));
  EXPECT_EQ(map.geo_reference->west_m, 1000.0);
  EXPECT_EQ(map.geo_reference->south_m, 4996.0);
}

TEST_F(MapPlacement, TiePointsMayLieAnywhere) {
  testing::write_geotiff(folder_ / "t.tif", 4, 3,
                         {.pixel_scale = {2, 2, 0}, .tie_points = {4, 3, 0, 1008, 4994, 0}});
  const Map map = read(spec("t.tif"));
  EXPECT_EQ(map.geo_reference->west_m, 1001.0);
  EXPECT_EQ(map.geo_reference->south_m, 4995.0);
}

TEST_F(MapPlacement, ATransformationWithoutTurnWillDo) {
  std::vector<double> matrix{2, 0, 0, 1000, 0, -2, 0, 5000, 0, 0, 0, 0, 0, 0, 0, 1};
  testing::write_geotiff(folder_ / "m.tif", 4, 3, {.transformation = matrix});
  EXPECT_EQ(read(spec("m.tif")).geo_reference->south_m, 4995.0);
  matrix[1] = 0.5;
  testing::write_geotiff(folder_ / "turned.tif", 4, 3, {.transformation = matrix});
  EXPECT_TRUE(warns_of(spec("turned.tif"), "turned"));
}

TEST_F(MapPlacement, WorldFileServesWhereTagsAreMissing) {
  testing::write_image<float>(folder_ / "w.exr", 2, 3, 1, OIIO::TypeDesc::FLOAT, {1, 2, 3, 4, 5, 6});
  testing::write_text(folder_ / "w.wld", "0.5\n0\n0\n-0.5\n100.25\n200.75\n");
  const Map map = read(spec("w.exr"));
  EXPECT_EQ(map.grid.frame().spacing_m, 0.5);
  EXPECT_EQ(map.geo_reference->west_m, 100.25);
  EXPECT_EQ(map.geo_reference->south_m, 199.75);
  EXPECT_EQ(map.geo_reference->wkt, "");
}

TEST_F(MapPlacement, TheSceneOverrides) {
  testing::write_geotiff(folder_ / "a.tif", 4, 3,
                         {.pixel_scale = {2, 2, 0}, .tie_points = {0, 0, 0, 1000, 5000, 0}});
  MapSpec override = spec("a.tif");
  override.spacing_m = 4.0;
  const Map map = read(override);
  EXPECT_EQ(map.grid.frame().spacing_m, 4.0);
  EXPECT_EQ(map.geo_reference->pixel_size_m, 4.0);
}

TEST_F(MapPlacement, UnknownPixelSizeAsksForSpacing) {
  testing::write_geotiff(folder_ / "bare.tif", 4, 3, {});
  EXPECT_TRUE(has(refusal(spec("bare.tif")), "`spacing_m`"));
}

TEST_F(MapPlacement, DegreesBecomeMetresOfUtm) {
  testing::write_geotiff(folder_ / "deg.tif", 40, 30,
                         {.pixel_scale = {0.0003, 0.0003, 0},
                          .tie_points = {0, 0, 0, 14.5, 46.0, 0},
                          .keys = {1, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326}});
  const Map map = read(spec("deg.tif"));
  ASSERT_TRUE(map.geo_reference.has_value());
  EXPECT_TRUE(has(map.geo_reference->wkt, "UTM zone 33N"));
  EXPECT_NEAR(map.grid.frame().spacing_m, 0.0003 * 77'400.0, 0.05) << "a degree of longitude at 46°";
  EXPECT_TRUE(warns_of(spec("deg.tif"), "degrees"));
  MapSpec override = spec("deg.tif");
  override.spacing_m = 30.0;
  EXPECT_EQ(read(override).grid.frame().spacing_m, 30.0);
}

TEST_F(MapPlacement, DegreesWithoutASystemAskForIt) {
  testing::write_geotiff(folder_ / "deg.tif", 40, 30,
                         {.pixel_scale = {0.0003, 0.0003, 0}, .tie_points = {0, 0, 0, 14.5, 46.0, 0}});
  EXPECT_TRUE(has(refusal(spec("deg.tif")), "`crs`"));
  MapSpec advised = spec("deg.tif");
  advised.crs = "EPSG:4326";
  EXPECT_TRUE(has(read(advised).geo_reference->wkt, "UTM zone 33N"));
  advised.crs = "EPSG:nonsense";
  EXPECT_TRUE(has(refusal(advised), "EPSG:nonsense"));
}

TEST_F(MapPlacement, FeetBecomeMetres) {
  testing::write_geotiff(folder_ / "ft.tif", 40, 30,
                         {.pixel_scale = {5, 5, 0},
                          .tie_points = {0, 0, 0, 2'000'000, 700'000, 0},
                          .keys = {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2264}});
  const Map map = read(spec("ft.tif"));
  EXPECT_TRUE(has(map.geo_reference->wkt, "UTM zone 17N")) << map.geo_reference->wkt;
  EXPECT_NEAR(map.grid.frame().spacing_m, 5.0 * 1200.0 / 3937.0, 2e-3);
}

TEST_F(MapPlacement, PixelsHaveAnyShapeButSomeSize) {
  for (const std::vector<double>& scale : {std::vector<double>{0.0, 0.0, 0}, {1e30, 1e30, 0}}) {
    testing::write_geotiff(folder_ / "s.tif", 4, 3, {.pixel_scale = scale, .tie_points = {0, 0, 0, 0, 0, 0}});
    const std::string message = refusal(spec("s.tif"));
    EXPECT_TRUE(has(message, "pixels") || has(message, "geo-reference")) << message;
  }
  testing::write_geotiff(folder_ / "oblong.tif", 40, 30,
                         {.pixel_scale = {2.0, 1.0, 0}, .tie_points = {0, 0, 0, 500'000, 5e6, 0}});
  const GridFrame oblong = read(spec("oblong.tif")).grid.frame();
  EXPECT_EQ(oblong.spacing_m, 1.0);
  EXPECT_EQ(oblong.columns, 79);
  EXPECT_EQ(oblong.rows, 30);
  testing::write_geotiff(folder_ / "ok.tif", 4, 3,
                         {.pixel_scale = {1.0, 1.0005, 0}, .tie_points = {0, 0, 0, 500'000, 5e6, 0}});
  EXPECT_EQ(read(spec("ok.tif")).grid.frame().spacing_m, 1.0);
}

TEST_F(MapPlacement, WorldFilesMayTurnAndMirror) {
  testing::write_image<float>(folder_ / "w.exr", 2, 3, 1, OIIO::TypeDesc::FLOAT, {1, 2, 3, 4, 5, 6});
  const auto values = [&](const char* text) {
    testing::write_text(folder_ / "w.wld", text);
    const Map map = read(spec("w.exr"));
    return std::vector<float>(map.grid.values().begin(), map.grid.values().end());
  };
  EXPECT_EQ(values("1\n0\n0\n-1\n500000\n5000000\n"), (std::vector<float>{5, 6, 3, 4, 1, 2}));
  EXPECT_EQ(values("1\n0\n0\n1\n500000\n5000000\n"), (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(values("-1\n0\n0\n-1\n500000\n5000000\n"), (std::vector<float>{6, 5, 4, 3, 2, 1}));
  // Columns run north, rows east: a quarter turn to the left.
  EXPECT_EQ(values("0\n1\n1\n0\n500000\n5000000\n"), (std::vector<float>{1, 3, 5, 2, 4, 6}));
}

}  // namespace
}  // namespace prairie
