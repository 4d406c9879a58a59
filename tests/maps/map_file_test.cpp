// What a file's numbers become, for every number format, channel layout and nodata convention.
#include "maps/map_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "files/error.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using OIIO::TypeDesc;
using testing::write_image;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

MapSpec spec_of(const std::filesystem::path& file) {
  MapSpec spec;
  spec.file = file;
  spec.field = "layers.map";
  spec.spacing_m = 1.0;
  return spec;
}

std::vector<float> values_of(const MapSpec& spec, MapMeaning meaning) {
  const Map map = read_map(spec, meaning, kBudget);
  return {map.grid.values().begin(), map.grid.values().end()};
}

std::string refusal(const MapSpec& spec, MapMeaning meaning) {
  try {
    read_map(spec, meaning, kBudget);
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.field, spec.field);
    EXPECT_EQ(fault.file, spec.file.string());
    return fault.what();
  }
  ADD_FAILURE() << "was read";
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class MapFile : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(MapFile, FirstRowIsNorth) {
  write_image<float>(folder_ / "a.tif", 2, 3, 1, TypeDesc::FLOAT, {1, 2, 3, 4, 5, 6});
  const Map map = read_map(spec_of(folder_ / "a.tif"), MapMeaning::kHeight, kBudget);
  EXPECT_EQ(std::vector<float>(map.grid.values().begin(), map.grid.values().end()),
            (std::vector<float>{5, 6, 3, 4, 1, 2}));
  EXPECT_EQ(map.grid.sample({0.0, 2.0}), 1.0f);  // north-west
  EXPECT_EQ(map.grid.frame().origin_m, glm::dvec2(0.0));
}

TEST_F(MapFile, IntegersCoverTheFullRangeOfTheirType) {
  write_image<std::uint8_t>(folder_ / "u8.png", 3, 1, 1, TypeDesc::UINT8, {0, 51, 255});
  write_image<std::uint16_t>(folder_ / "u16.png", 3, 1, 1, TypeDesc::UINT16, {0, 13107, 65535});
  write_image<std::uint16_t>(folder_ / "u16.tif", 3, 1, 1, TypeDesc::UINT16, {0, 13107, 65535});
  write_image<std::int16_t>(folder_ / "i16.tif", 4, 1, 1, TypeDesc::INT16, {0, 6553, 32767, -5});
  write_image<std::uint32_t>(folder_ / "u32.tif", 3, 1, 1, TypeDesc::UINT32, {0, 858993459u, 4294967295u});
  write_image<std::int32_t>(folder_ / "i32.tif", 3, 1, 1, TypeDesc::INT32, {0, 429496729, 2147483647});
  for (const char* name : {"u8.png", "u16.png", "u16.tif", "i16.tif", "u32.tif", "i32.tif"}) {
    MapSpec spec = spec_of(folder_ / name);
    spec.max = 10.0;
    const std::vector<float> values = values_of(spec, MapMeaning::kDensity);
    EXPECT_EQ(values[0], 0.0f) << name;
    EXPECT_NEAR(values[1], 2.0f, 1e-3f) << name;
    EXPECT_EQ(values[2], 10.0f) << name;
    if (values.size() > 3) {
      EXPECT_EQ(values[3], 0.0f) << name;
    }
  }
}

TEST_F(MapFile, FloatsAreTakenAsTheyAre) {
  const std::vector<float> pixels{0.0f, 0.25f, 1.0f, 0.125f};
  write_image(folder_ / "f.tif", 4, 1, 1, TypeDesc::FLOAT, pixels);
  write_image(folder_ / "f.exr", 4, 1, 1, TypeDesc::FLOAT, pixels);
  write_image(folder_ / "h.exr", 4, 1, 1, TypeDesc::HALF, pixels);
  for (const char* name : {"f.tif", "f.exr", "h.exr"}) {
    EXPECT_EQ(values_of(spec_of(folder_ / name), MapMeaning::kDensity), pixels) << name;
    EXPECT_EQ(values_of(spec_of(folder_ / name), MapMeaning::kHeight), pixels) << name;
  }
}

TEST_F(MapFile, DoublesAreRead) {
  write_image<double>(folder_ / "d.tif", 2, 1, 1, TypeDesc::DOUBLE, {0.25, 1.0 / 3.0});
  EXPECT_EQ(values_of(spec_of(folder_ / "d.tif"), MapMeaning::kHeight),
            (std::vector<float>{0.25f, static_cast<float>(1.0 / 3.0)}));
}

TEST_F(MapFile, TiledFilesReadLikeOthers) {
  std::vector<float> pixels;
  for (int j = 0; j < 70; ++j) {
    for (int i = 0; i < 90; ++i) pixels.push_back(static_cast<float>(j * 90 + i));
  }
  write_image(folder_ / "rows.tif", 90, 70, 1, TypeDesc::FLOAT, pixels);
  write_image(folder_ / "tiles.tif", 90, 70, 1, TypeDesc::FLOAT, pixels, {}, 32);
  write_image(folder_ / "tiles.exr", 90, 70, 1, TypeDesc::FLOAT, pixels, {}, 16);
  const std::vector<float> rows = values_of(spec_of(folder_ / "rows.tif"), MapMeaning::kHeight);
  EXPECT_EQ(rows[0], pixels[69 * 90]);
  EXPECT_EQ(values_of(spec_of(folder_ / "tiles.tif"), MapMeaning::kHeight), rows);
  EXPECT_EQ(values_of(spec_of(folder_ / "tiles.exr"), MapMeaning::kHeight), rows);
}

TEST_F(MapFile, DensityFollowsRangeCurveAndMax) {
  write_image<float>(folder_ / "ndvi.tif", 5, 1, 1, TypeDesc::FLOAT, {-0.1f, 0.2f, 0.5f, 0.8f, 1.0f});
  MapSpec spec = spec_of(folder_ / "ndvi.tif");
  spec.range = {{0.2, 0.8}};
  spec.curve = 2.0;
  spec.max = 1000.0;
  const Map map = read_map(spec, MapMeaning::kDensity, kBudget);
  EXPECT_EQ(map.grid.values()[0], 0.0f);
  EXPECT_NEAR(map.grid.values()[2], 250.0f, 1e-3f);
  EXPECT_EQ(map.grid.values()[4], 1000.0f);
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_TRUE(has(map.warnings[0].text, "40.0 % of the values lie outside the range"))
      << map.warnings[0].text;
  // A factor is straight.
  EXPECT_NEAR(values_of(spec, MapMeaning::kFactor)[2], 500.0f, 1e-3f);
  // Dark may mean dense.
  spec.range = {{0.8, 0.2}};
  EXPECT_EQ(values_of(spec, MapMeaning::kDensity)[0], 1000.0f);
}

TEST_F(MapFile, DensityIsNeverDecodedAndColourIs) {
  OIIO::ParamValueList attributes;
  attributes.attribute("oiio:ColorSpace", "sRGB");
  write_image<std::uint8_t>(folder_ / "grey.png", 2, 1, 1, TypeDesc::UINT8, {128, 255}, attributes);
  EXPECT_NEAR(values_of(spec_of(folder_ / "grey.png"), MapMeaning::kDensity)[0], 128.0f / 255.0f, 1e-6f);
  const std::vector<float> colour = values_of(spec_of(folder_ / "grey.png"), MapMeaning::kColor);
  ASSERT_EQ(colour.size(), 6u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], 0.2158605f, 1e-6f);
  EXPECT_EQ(colour[3], 1.0f);

  write_image<float>(folder_ / "linear.exr", 1, 1, 3, TypeDesc::FLOAT, {0.5f, 0.25f, 2.0f});
  EXPECT_EQ(values_of(spec_of(folder_ / "linear.exr"), MapMeaning::kColor),
            (std::vector<float>{0.5f, 0.25f, 2.0f}));
}

TEST_F(MapFile, IntegerHeightsNeedARange) {
  write_image<std::uint16_t>(folder_ / "h.png", 3, 1, 1, TypeDesc::UINT16, {0, 32768, 65535});
  MapSpec spec = spec_of(folder_ / "h.png");
  EXPECT_TRUE(has(refusal(spec, MapMeaning::kHeight), "`range`"));
  spec.range = {{100.0, 200.0}};
  const std::vector<float> values = values_of(spec, MapMeaning::kHeight);
  EXPECT_EQ(values[0], 100.0f);
  EXPECT_NEAR(values[1], 150.0008f, 1e-4f);
  EXPECT_EQ(values[2], 200.0f);
}

TEST_F(MapFile, ThreeEqualChannelsAreGrey) {
  write_image<std::uint8_t>(folder_ / "rgb.png", 2, 1, 3, TypeDesc::UINT8, {51, 51, 51, 255, 255, 255});
  EXPECT_EQ(values_of(spec_of(folder_ / "rgb.png"), MapMeaning::kDensity), (std::vector<float>{0.2f, 1.0f}));
  write_image<std::uint8_t>(folder_ / "rgba.png", 2, 1, 4, TypeDesc::UINT8,
                            {51, 51, 51, 255, 255, 255, 255, 255});
  EXPECT_EQ(values_of(spec_of(folder_ / "rgba.png"), MapMeaning::kDensity), (std::vector<float>{0.2f, 1.0f}));
}

TEST_F(MapFile, DifferentChannelsNeedAName) {
  write_image<std::uint8_t>(folder_ / "rgba.png", 2, 1, 4, TypeDesc::UINT8,
                            {10, 51, 30, 7, 40, 255, 60, 102});
  MapSpec spec = spec_of(folder_ / "rgba.png");
  const std::string message = refusal(spec, MapMeaning::kDensity);
  EXPECT_TRUE(has(message, "channels R, G, B, A")) << message;
  EXPECT_TRUE(has(message, "`channel`")) << message;
  spec.channel = "G";
  EXPECT_EQ(values_of(spec, MapMeaning::kDensity), (std::vector<float>{0.2f, 1.0f}));
  spec.channel = "A";
  EXPECT_NEAR(values_of(spec, MapMeaning::kDensity)[1], 0.4f, 1e-6f);
  spec.channel = "X";
  EXPECT_TRUE(has(refusal(spec, MapMeaning::kDensity), "R, G, B, A"));
  // Veiled grey is not grey.
  write_image<std::uint8_t>(folder_ / "veiled.png", 1, 1, 4, TypeDesc::UINT8, {10, 10, 10, 7});
  EXPECT_TRUE(has(refusal(spec_of(folder_ / "veiled.png"), MapMeaning::kDensity), "`channel`"));
}

TEST_F(MapFile, AlphaDoesNotTouchTheData) {
  std::vector<std::uint16_t> pixels;
  for (int k = 0; k < 64; ++k) {
    for (const int value : {k * 1000 + 7, 65535 - k * 900, k * 17, k * 3}) {
      pixels.push_back(static_cast<std::uint16_t>(value));
    }
  }
  for (const char* name : {"data.png", "data.tif"}) {
    write_image(folder_ / name, 64, 1, 4, TypeDesc::UINT16, pixels);
    MapSpec spec = spec_of(folder_ / name);
    spec.channel = "R";
    spec.range = {{0.0, 65535.0}};
    spec.max = 65535.0;
    const std::vector<float> values = values_of(spec, MapMeaning::kFactor);
    for (std::size_t k = 0; k < 64; ++k) EXPECT_EQ(values[k], static_cast<float>(k * 1000 + 7));
  }
}

TEST_F(MapFile, EveryCustomaryNodataIsAGap) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  write_image<float>(folder_ / "n.tif", 8, 1, 1, TypeDesc::FLOAT,
                     {1.0f, -9999.0f, -3.4028235e38f, 3.4028235e38f, kNaN, kInfinity, -32767.0f, 2.0f});
  MapSpec spec = spec_of(folder_ / "n.tif");
  spec.nodata = -32767.0;
  const Map map = read_map(spec, MapMeaning::kHeight, kBudget);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(std::isnan(map.grid.values()[k]), k != 0 && k != 7) << k;
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_TRUE(has(map.warnings[0].text, "75.0 % of the nodes have no data"));

  write_image<std::int16_t>(folder_ / "i.tif", 4, 1, 1, TypeDesc::INT16, {100, -9999, -32768, 200});
  spec = spec_of(folder_ / "i.tif");
  spec.nodata = -32768.0;
  spec.range = {{0.0, 32767.0}};
  std::vector<float> values = values_of(spec, MapMeaning::kHeight);
  EXPECT_EQ(values[0], 100.0f);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[2]));

  write_image<std::uint8_t>(folder_ / "u.png", 2, 1, 1, TypeDesc::UINT8, {255, 0});
  spec = spec_of(folder_ / "u.png");
  spec.nodata = 255.0;
  values = values_of(spec, MapMeaning::kDensity);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], 0.0f);

  // −9999 is no half; the nearest one is.
  write_image<float>(folder_ / "h.exr", 2, 1, 1, TypeDesc::HALF, {-9999.0f, 1.0f});
  EXPECT_TRUE(std::isnan(values_of(spec_of(folder_ / "h.exr"), MapMeaning::kHeight)[0]));

  write_image<std::int32_t>(folder_ / "l.tif", 3, 1, 1, TypeDesc::INT32,
                            {std::numeric_limits<std::int32_t>::min(), -9999, 7});
  spec = spec_of(folder_ / "l.tif");
  spec.nodata = -2147483648.0;
  values = values_of(spec, MapMeaning::kDensity);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_FALSE(std::isnan(values[2]));
}

TEST_F(MapFile, TheFilesOwnNodataCountsUnlessTheSceneSaysOtherwise) {
  testing::write_geotiff(folder_ / "g.tif", 2, 2, {.pixel_scale = {1, 1, 0}, .nodata = "1"});
  EXPECT_TRUE(has(refusal(spec_of(folder_ / "g.tif"), MapMeaning::kDensity), "no pixel with data"));
  MapSpec spec = spec_of(folder_ / "g.tif");
  spec.nodata = 0.0;
  EXPECT_EQ(values_of(spec, MapMeaning::kDensity)[0], 1.0f);
}

TEST_F(MapFile, WarnsOfMapsThatAreProbablyNotMeant) {
  write_image<std::uint8_t>(folder_ / "black.png", 2, 2, 1, TypeDesc::UINT8, {0, 0, 0, 0});
  Map map = read_map(spec_of(folder_ / "black.png"), MapMeaning::kDensity, kBudget);
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_TRUE(has(map.warnings[0].text, "nothing grows"));
  write_image<std::uint8_t>(folder_ / "flat.png", 2, 2, 1, TypeDesc::UINT8, {9, 9, 9, 9});
  map = read_map(spec_of(folder_ / "flat.png"), MapMeaning::kDensity, kBudget);
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_TRUE(has(map.warnings[0].text, "same value"));
}

TEST_F(MapFile, ImpossibleNumbersAreRefused) {
  write_image<float>(folder_ / "f.tif", 2, 1, 1, TypeDesc::FLOAT, {1.0f, 2.0f});
  const auto refused = [&](auto change, const char* part) {
    MapSpec spec = spec_of(folder_ / "f.tif");
    change(spec);
    const std::string message = refusal(spec, MapMeaning::kDensity);
    EXPECT_TRUE(has(message, part)) << message;
  };
  refused([](MapSpec& s) { s.max = -1.0; }, "`max`");
  refused([](MapSpec& s) { s.max = 1e6; }, "`max`");
  refused([](MapSpec& s) { s.max = std::nan(""); }, "`max`");
  refused([](MapSpec& s) { s.curve = 0.0; }, "`curve`");
  refused([](MapSpec& s) { s.range = {{1.0, 1.0}}; }, "`range`");
  refused([](MapSpec& s) { s.range = {{0.0, std::nan("")}}; }, "`range`");
  refused([](MapSpec& s) { s.spacing_m = 0.0; }, "`spacing_m`");
  refused([](MapSpec& s) { s.spacing_m = std::nan(""); }, "`spacing_m`");

  write_image<float>(folder_ / "wild.tif", 2, 1, 1, TypeDesc::FLOAT, {1.0f, 1e20f});
  EXPECT_TRUE(has(refusal(spec_of(folder_ / "wild.tif"), MapMeaning::kHeight), "`nodata`"));
}

TEST_F(MapFile, HashIsOfTheFilesBytes) {
  write_image<std::uint8_t>(folder_ / "a.png", 2, 1, 1, TypeDesc::UINT8, {1, 2});
  write_image<std::uint8_t>(folder_ / "b.png", 2, 1, 1, TypeDesc::UINT8, {1, 3});
  std::filesystem::copy_file(folder_ / "a.png", folder_ / "c.png");
  const auto hash = [&](const char* name) {
    return read_map(spec_of(folder_ / name), MapMeaning::kDensity, kBudget).content_hash;
  };
  EXPECT_EQ(hash("a.png"), hash("c.png"));
  EXPECT_NE(hash("a.png"), hash("b.png"));
}

}  // namespace
}  // namespace prairie
