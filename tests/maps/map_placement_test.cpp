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
  EXPECT_TRUE(has(refusal(spec("turned.tif")), "turned"));
}

TEST_F(MapPlacement, WorldFileServesWhereTagsAreMissing) {
  testing::write_image<float>(folder_ / "w.exr", 2, 3, 1, OIIO::TypeDesc::FLOAT, {1, 2, 3, 4, 5, 6});
  testing::write_text(folder_ / "w.wld", "0.5\n0\n0\n-0.5\n100.25\n200.75\n");
  const Map map = read(spec("w.exr"));
  EXPECT_EQ(map.grid.frame().spacing_m, 0.5);
  EXPECT_EQ(map.geo_reference->west_m, 100.25);
  EXPECT_EQ(map.geo_reference->south_m, 199.75);
  EXPECT_TRUE(map.geo_reference->geo_keys.empty());
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

TEST_F(MapPlacement, DegreesAreNoMetres) {
  testing::write_geotiff(folder_ / "deg.tif", 4, 3,
                         {.pixel_scale = {0.0003, 0.0003, 0},
                          .tie_points = {0, 0, 0, 14.5, 46.0, 0},
                          .keys = {1, 1, 0, 2, 1024, 0, 1, 2, 1025, 0, 1, 1}});
  const std::string message = refusal(spec("deg.tif"));
  EXPECT_TRUE(has(message, "degrees") && has(message, "metres") && has(message, "projected")) << message;
  MapSpec override = spec("deg.tif");
  override.spacing_m = 30.0;
  EXPECT_FALSE(read(override).geo_reference.has_value());
}

TEST_F(MapPlacement, FeetAreNoMetres) {
  testing::write_geotiff(folder_ / "ft.tif", 4, 3,
                         {.pixel_scale = {3, 3, 0},
                          .tie_points = {0, 0, 0, 0, 0, 0},
                          .keys = {1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9003}});
  EXPECT_TRUE(has(refusal(spec("ft.tif")), "9003"));
}

TEST_F(MapPlacement, PixelsMustBeSquareAndOfSomeSize) {
  for (const std::vector<double>& scale :
       {std::vector<double>{1.0, 1.01, 0}, {0.0, 0.0, 0}, {-1.0, -1.0, 0}, {1e30, 1e30, 0}}) {
    testing::write_geotiff(folder_ / "s.tif", 4, 3, {.pixel_scale = scale, .tie_points = {0, 0, 0, 0, 0, 0}});
    EXPECT_TRUE(has(refusal(spec("s.tif")), "pixel")) << scale[0];
  }
  testing::write_geotiff(folder_ / "ok.tif", 4, 3, {.pixel_scale = {1.0, 1.0005, 0}});
  EXPECT_EQ(read(spec("ok.tif")).grid.frame().spacing_m, 1.0);

  testing::write_image<float>(folder_ / "w.exr", 1, 2, 1, OIIO::TypeDesc::FLOAT, {1, 2});
  testing::write_text(folder_ / "w.wld", "1\n0.1\n0\n-1\n0\n0\n");
  EXPECT_TRUE(has(refusal(spec("w.exr")), "turned"));
  testing::write_text(folder_ / "w.wld", "1\n0\n0\n1\n0\n0\n");
  EXPECT_TRUE(has(refusal(spec("w.exr")), "first row north"));
}

}  // namespace
}  // namespace prairie
