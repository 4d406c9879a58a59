#include "pictures/picture_encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "files/error.h"
#include "maps/georaster/spatial_reference.h"
#include "maps/geotiff_output.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;

MapSpec spec_of(const std::filesystem::path& file) {
  MapSpec spec;
  spec.file = file;
  spec.field = "map";
  spec.spacing_m = 1.0;
  return spec;
}

bool holds(const std::vector<std::byte>& bytes, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find(text) !=
         std::string_view::npos;
}

TEST(ImageOutput, GreyComesBackAsItWas) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> grey;
  for (int k = 0; k < 256; ++k) grey.push_back(static_cast<std::uint16_t>(k * 257));
  testing::write_bytes(folder / "g.png", encode_png_grey16(16, 16, grey));
  MapSpec spec = spec_of(folder / "g.png");
  spec.max = 65535.0;
  const Map map = read_map(spec, MapMeaning::kFactor, kBudget);
  EXPECT_EQ(map.grid.sample({3.0, 15.0}), 3.0f * 257.0f);  // first row north

  const std::vector<std::uint8_t> small{0, 128, 255, 7};
  testing::write_bytes(folder / "s.png", encode_png_grey8(2, 2, small));
  spec = spec_of(folder / "s.png");
  spec.max = 255.0;
  EXPECT_EQ(read_map(spec, MapMeaning::kFactor, kBudget).grid.sample({1.0, 1.0}), 128.0f);
}

TEST(ImageOutput, ColoursComeBackAsTheyWere) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "c.exr",
                       encode_exr_rgb(2, 1, std::vector<float>{0.1f, 0.2f, 0.3f, 4.0f, 5.0f, 6.0f}));
  const Map map = read_map(spec_of(folder / "c.exr"), MapMeaning::kColor, kBudget);
  EXPECT_EQ(map.grid.values()[1], 0.2f);
  EXPECT_EQ(map.grid.values()[5], 6.0f);

  testing::write_bytes(folder / "c.png", encode_png_rgb8(1, 1, std::vector<std::uint8_t>{255, 128, 0}));
  EXPECT_NEAR(read_map(spec_of(folder / "c.png"), MapMeaning::kColor, kBudget).grid.values()[1], 0.2158605f,
              1e-6f);
}

TEST(ImageOutput, BytesDoNotDependOnTheClock) {
  const std::vector<std::uint8_t> rgb(3 * 64 * 64, 100);
  const std::vector<float> linear(3 * 64 * 64, 0.5f);
  const NodeGrid grid({64, 64, 1.0, {0.0, 0.0}, false}, 1, std::vector<float>(64 * 64, 1.0f));
  for (const auto& bytes :
       {encode_png_rgb8(64, 64, rgb), encode_exr_rgb(64, 64, linear), encode_geotiff(grid, nullptr)}) {
    for (const char* text : {"DateTime", "tIME", "Software", "HostComputer", "OpenImageIO"}) {
      EXPECT_FALSE(holds(bytes, text)) << text;
    }
  }
  EXPECT_TRUE(holds(encode_exr_rgb(64, 64, linear), "1970:01:01 00:00:00"));
  EXPECT_EQ(encode_png_rgb8(64, 64, rgb), encode_png_rgb8(64, 64, rgb));
  EXPECT_EQ(encode_exr_rgb(64, 64, linear), encode_exr_rgb(64, 64, linear));
  EXPECT_EQ(encode_geotiff(grid, nullptr), encode_geotiff(grid, nullptr));
}

TEST(ImageOutput, GeoTiffKeepsPlaceNodataAndCoordinateSystem) {
  const TemporaryFolder folder;
  std::vector<float> values;
  for (int k = 0; k < 30 * 200; ++k) values.push_back(testing::rolling_height_m(k % 30, k));
  values[77] = std::numeric_limits<float>::quiet_NaN();
  const NodeGrid grid({30, 200, 0.5, {0.0, 0.0}, false}, 1, values);
  GeoReference reference;
  reference.pixel_size_m = 0.5;
  reference.west_m = 702000.25;
  reference.south_m = 4333000.25;
  reference.wkt = SpatialReference::of_name("EPSG:32614")->wkt();
  testing::write_bytes(folder / "g.tif", encode_geotiff(grid, &reference));

  MapSpec spec = spec_of(folder / "g.tif");
  spec.spacing_m.reset();
  const Map map = read_map(spec, MapMeaning::kHeight, kBudget);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k == 77) {
      EXPECT_TRUE(std::isnan(map.grid.values()[k]));
    } else {
      EXPECT_EQ(map.grid.values()[k], values[k]);
    }
  }
  EXPECT_EQ(map.grid.frame().spacing_m, 0.5);
  ASSERT_TRUE(map.geo_reference.has_value());
  EXPECT_EQ(map.geo_reference->west_m, reference.west_m);
  EXPECT_EQ(map.geo_reference->south_m, reference.south_m);
  EXPECT_EQ(SpatialReference::of_wkt(map.geo_reference->wkt)->epsg(), 32614);
}

TEST(ImageOutput, GeoTiffWithoutReferenceLiesWhereItsFrameDoes) {
  const TemporaryFolder folder;
  const NodeGrid grid({3, 2, 2.0, {10.0, 20.0}, false}, 1, {1, 2, 3, 4, 5, 6});
  testing::write_bytes(folder / "g.tif", encode_geotiff(grid, nullptr));
  MapSpec spec = spec_of(folder / "g.tif");
  spec.spacing_m.reset();
  const Map map = read_map(spec, MapMeaning::kHeight, kBudget);
  EXPECT_EQ(map.geo_reference->west_m, 10.0);
  EXPECT_EQ(map.geo_reference->south_m, 20.0);
}

}  // namespace
}  // namespace prairie
