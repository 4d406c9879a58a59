// Images as terrain tools, cameras, painters and engines write them mean what their makers meant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "files/error.h"
#include "files/fallible_work.h"
#include "maps/height_field.h"
#include "maps/map_file.h"
#include "maps/map_work.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using OIIO::TypeDesc;
using testing::write_image;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;

/// Made before any thread.
WorkerProcess g_decoder(fallible(chosen_by_name(map_works())));

class ForeignImages : public ::testing::Test {
 protected:
  MapSpec spec(const std::string& name) const {
    MapSpec result;
    result.file = folder_ / name;
    result.field = "map";
    result.spacing_m = 1.0;
    return result;
  }
  /// Column and row from the west and the north, as one looks at a picture.
  static float pixel(const Map& map, int column, int row) {
    std::vector<float> value(1);
    map.grid.read_block({column, map.grid.frame().rows - 1 - row, 1, 1}, value);
    return value[0];
  }
  static std::string refusal(const MapSpec& spec, MapMeaning meaning, WorkerProcess* decoder = nullptr) {
    try {
      read_map(spec, meaning, kBudget, nullptr, decoder);
    } catch (const BadInput& fault) {
      return fault.what();
    }
    return "";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  TemporaryFolder folder_;
};

constexpr int kWidth = 6, kHeight = 9;

/// An F, as letters are told from their mirror images.
bool is_ink(int column, int row) {
  return column == 1 || (row == 1 && column >= 1) || (row == 4 && column >= 1 && column < 4);
}

/// The F as it is stored in a file of that orientation (EXIF, 1…8).
std::vector<std::uint8_t> stored(int orientation, int& width, int& height) {
  const bool is_transposed = orientation >= 5;
  width = is_transposed ? kHeight : kWidth;
  height = is_transposed ? kWidth : kHeight;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height));
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      // Which side of the picture the first row and the first column of the file are (EXIF 2.3, 4.6.4 A).
      const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
      const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
      const int x = from_right ? kWidth - 1 - column : column, y = from_bottom ? kHeight - 1 - row : row;
      const int at = is_transposed ? x * width + y : y * width + x;
      pixels[static_cast<std::size_t>(at)] = is_ink(column, row) ? 255 : 0;
    }
  }
  return pixels;
}

TEST_F(ForeignImages, AreTurnedUpright) {
  for (const char* name : {"f.tif", "f.jpg"}) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
      SCOPED_TRACE(std::string(name) + ", orientation " + std::to_string(orientation));
      int width = 0, height = 0;
      const std::vector<std::uint8_t> pixels = stored(orientation, width, height);
      OIIO::ParamValueList attributes;
      attributes.attribute("Orientation", orientation);
      attributes.attribute("CompressionQuality", 100);
      write_image(folder_ / name, width, height, 1, TypeDesc::UINT8, pixels, attributes);
      const Map map = read_map(spec(name), MapMeaning::kDensity, kBudget);
      ASSERT_EQ(map.grid.frame().columns, kWidth);
      ASSERT_EQ(map.grid.frame().rows, kHeight);
      for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column)
          EXPECT_EQ(pixel(map, column, row) > 0.5f, is_ink(column, row)) << column << ", " << row;
      }
    }
  }
}

TEST_F(ForeignImages, AnExrsPixelsLieInItsDisplayWindow) {
  OIIO::ImageSpec whole(4, 3, 1, TypeDesc::FLOAT);
  whole.x = 5;
  whole.y = 2;
  whole.full_width = 16;
  whole.full_height = 10;
  const std::string path = (folder_ / "cropped.exr").string();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output->open(path, whole));
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, std::vector<float>(12, 0.5f).data()));
  output->close();
  const Map map = read_map(spec("cropped.exr"), MapMeaning::kDensity, kBudget);
  ASSERT_EQ(map.grid.frame().columns, 16);
  ASSERT_EQ(map.grid.frame().rows, 10);
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 16; ++column) {
      const bool is_inside = column >= 5 && column < 9 && row >= 2 && row < 5;
      const float value = pixel(map, column, row);
      EXPECT_TRUE(is_inside ? value == 0.5f : std::isnan(value)) << column << ", " << row;
    }
  }
}

TEST_F(ForeignImages, AMaskMayStandInAlpha) {
  std::vector<std::uint8_t> pixels;
  for (int k = 0; k < 64; ++k) pixels.insert(pixels.end(), {10, 20, 30, static_cast<std::uint8_t>(k * 4)});
  write_image(folder_ / "mask.png", 8, 8, 4, TypeDesc::UINT8, pixels);
  EXPECT_TRUE(has(refusal(spec("mask.png"), MapMeaning::kDensity), "`channel`"));
  for (const char* name : {"A", "a", "4"}) {
    MapSpec alpha = spec("mask.png");
    alpha.channel = name;
    alpha.max = 255.0;
    EXPECT_NEAR(pixel(read_map(alpha, MapMeaning::kDensity, kBudget), 1, 1), 36.0f, 1e-3f) << name;
  }
}

TEST_F(ForeignImages, HeightsOfZeroToOneTakeARange) {
  std::vector<float> shares;
  for (int k = 0; k < 64; ++k) shares.push_back(static_cast<float>(k) / 63.0f);
  for (const char* name : {"gaea.exr", "houdini.tif"}) {
    write_image(folder_ / name, 8, 8, 1, TypeDesc::FLOAT, shares);
    MapSpec ranged = spec(name);
    const Map plain = read_map(ranged, MapMeaning::kHeight, kBudget);
    EXPECT_TRUE(std::ranges::any_of(plain.warnings,
                                    [](const auto& warning) { return has(warning.text, "`range`"); }));
    ranged.range = {{10.0, 310.0}};
    const Map map = read_map(ranged, MapMeaning::kHeight, kBudget);
    EXPECT_NEAR(pixel(map, 0, 0), 10.0f, 1e-4f);
    EXPECT_NEAR(pixel(map, 7, 7), 310.0f, 1e-4f);
    ranged.range.reset();
    ranged.scale = 50.0;
    EXPECT_NEAR(pixel(read_map(ranged, MapMeaning::kHeight, kBudget), 7, 7), 50.0f, 1e-4f);
  }
  write_image(folder_ / "metres.exr", 8, 8, 1, TypeDesc::FLOAT, std::vector<float>(64, 300.0f));
  MapSpec metres = spec("metres.exr");
  metres.range = {{0.0, 100.0}};
  const Map map = read_map(metres, MapMeaning::kHeight, kBudget);
  EXPECT_EQ(pixel(map, 1, 1), 300.0f) << "they are metres already";
  EXPECT_TRUE(
      std::ranges::any_of(map.warnings, [](const auto& warning) { return has(warning.text, "not used"); }));
}

TEST_F(ForeignImages, HeightsInStairsAreWarnedOf) {
  std::vector<float> hills;
  for (int k = 0; k < 100 * 100; ++k)
    hills.push_back(0.5f + 0.1f * std::sin(static_cast<float>(k % 100) / 9.0f) *
                               std::cos(static_cast<float>(k) / 1100.0f));
  const auto codes = [&](const char* name, TypeDesc type, double spacing_m) {
    write_image(folder_ / name, 100, 100, 1, type, hills);
    MapSpec heights = spec(name);
    heights.range = {{0.0, 100.0}};
    heights.spacing_m = spacing_m;
    std::vector<std::string> found;
    for (const Warning& warning : read_map(heights, MapMeaning::kHeight, kBudget).warnings)
      found.push_back(warning.code);
    return found;
  };
  EXPECT_EQ(codes("h8.png", TypeDesc::UINT8, 1.0), std::vector<std::string>{"stairs"});
  EXPECT_EQ(codes("h16.png", TypeDesc::UINT16, 1.0), std::vector<std::string>());
  EXPECT_TRUE(codes("h8.png", TypeDesc::UINT8, 30.0).empty())
      << "steps of 0.4 m are nothing to nodes 30 m apart";
}

TEST_F(ForeignImages, AValueFarFromAllOthersIsWarnedOf) {
  std::vector<float> highland(64 * 64);
  for (std::size_t k = 0; k < highland.size(); ++k)
    highland[k] = k < 40 ? 0.0f : 1500.0f + 0.01f * static_cast<float>(k % 977);
  write_image(folder_ / "h.exr", 64, 64, 1, TypeDesc::FLOAT, highland);
  const Map map = read_map(spec("h.exr"), MapMeaning::kHeight, kBudget);
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_EQ(map.warnings[0].code, "lone-value");
  EXPECT_TRUE(has(map.warnings[0].text, "`nodata = 0`")) << map.warnings[0].text;
  MapSpec advised = spec("h.exr");
  advised.nodata = 0.0;
  EXPECT_EQ(HeightField(read_map(advised, MapMeaning::kHeight, kBudget).grid).range().min_m, 1500.0f);
  // A lake beside low land is ground.
  for (std::size_t k = 40; k < highland.size(); ++k) highland[k] = 0.01f * static_cast<float>(k % 977);
  write_image(folder_ / "lake.exr", 64, 64, 1, TypeDesc::FLOAT, highland);
  EXPECT_TRUE(read_map(spec("lake.exr"), MapMeaning::kHeight, kBudget).warnings.empty());
}

TEST_F(ForeignImages, RawHeightsOfEnginesNeedTheirSize) {
  std::string bytes;
  for (int k = 0; k < 12 * 5; ++k) {
    bytes.push_back(static_cast<char>((k * 1000) & 0xff));
    bytes.push_back(static_cast<char>(((k * 1000) >> 8) & 0xff));
  }
  for (const char* name : {"t.r16", "t.raw"}) {
    testing::write_text(folder_ / name, bytes);
    MapSpec raw = spec(name);
    raw.range = {{0.0, 65535.0}};
    EXPECT_TRUE(has(refusal(raw, MapMeaning::kHeight), "`size_px`"));
    raw.size_px = {12, 5};
    EXPECT_NEAR(pixel(read_map(raw, MapMeaning::kHeight, kBudget), 3, 2), 27'000.0f, 0.01f);
    raw.size_px = {12, 6};
    EXPECT_TRUE(has(refusal(raw, MapMeaning::kHeight), "12 × 6"));
  }
}

TEST_F(ForeignImages, AProgressiveJpegThatClaimsTooMuchIsRefusedAtOnce) {
  OIIO::ParamValueList attributes;
  attributes.attribute("jpeg:progressive", 1);
  write_image(folder_ / "p.jpg", 8, 8, 1, TypeDesc::UINT8, std::vector<std::uint8_t>(64, 77), attributes);
  ASSERT_EQ(refusal(spec("p.jpg"), MapMeaning::kDensity), "");
  std::vector<std::byte> bytes = testing::read_bytes(folder_ / "p.jpg");
  constexpr std::byte kFrame[] = {std::byte{0xff}, std::byte{0xc2}};
  const auto frame = std::search(bytes.begin(), bytes.end(), std::begin(kFrame), std::end(kFrame));
  ASSERT_NE(frame, bytes.end());
  for (int k = 5; k < 9; ++k) frame[k] = std::byte{0xff};
  testing::write_bytes(folder_ / "p.jpg", bytes);
  EXPECT_TRUE(has(refusal(spec("p.jpg"), MapMeaning::kDensity), "a claim of"));
}

TEST_F(ForeignImages, WhatCrashesALibraryIsReadOrRefused) {
  // Inks in tiles end OpenImageIO's reader.
  OIIO::ParamValueList attributes;
  attributes.attribute("tiff:ColorSpace", "CMYK");
  std::vector<std::uint8_t> pixels(32 * 32 * 4, 40);
  write_image(folder_ / "cmyk.tif", 32, 32, 4, TypeDesc::UINT8, pixels, attributes, 16);
  MapSpec inks = spec("cmyk.tif");
  inks.channel = "1";
  const std::string said = refusal(inks, MapMeaning::kDensity, &g_decoder);
  EXPECT_TRUE(said.empty() || has(said, "cmyk.tif")) << said;
  write_image(folder_ / "grey.png", 4, 4, 1, TypeDesc::UINT8, std::vector<std::uint8_t>(16, 40));
  EXPECT_EQ(refusal(spec("grey.png"), MapMeaning::kDensity, &g_decoder), "") << "after it";
}

TEST_F(ForeignImages, AWorkerReadsWhatThisProcessReads) {
  std::vector<std::uint16_t> pixels;
  for (int k = 0; k < 300 * 200; ++k) pixels.push_back(static_cast<std::uint16_t>(k * 31));
  write_image(folder_ / "a.png", 300, 200, 1, TypeDesc::UINT16, pixels);
  const Map here = read_map(spec("a.png"), MapMeaning::kDensity, kBudget);
  const Map there = read_map(spec("a.png"), MapMeaning::kDensity, kBudget, nullptr, &g_decoder);
  EXPECT_TRUE(std::ranges::equal(here.grid.values(), there.grid.values()));
  EXPECT_EQ(here.content_hash, there.content_hash);
  EXPECT_EQ(here.warnings, there.warnings);
  const MapRequest request{.spec = spec("a.png"), .meaning = MapMeaning::kDensity, .scene_wkt = ""};
  EXPECT_EQ(layout_of_map(request, &g_decoder).columns, layout_of_map(request, nullptr).columns);
}

}  // namespace
}  // namespace prairie
