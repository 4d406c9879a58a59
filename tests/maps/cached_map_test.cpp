// A map that stays on disk answers as one in memory does, bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <thread>

#include "files/error.h"
#include "maps/height_field.h"
#include "maps/map_file.h"
#include "pictures/picture_encoding.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using OIIO::TypeDesc;
using testing::write_image;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;
constexpr std::uint64_t kTinyBudget = 100'000;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void expect_same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::isnan(a[k]) && std::isnan(b[k])) continue;
    ASSERT_EQ(std::memcmp(&a[k], &b[k], sizeof(float)), 0) << k << ": " << a[k] << " and " << b[k];
  }
}

void expect_same_grids(const MapSpec& spec, MapMeaning meaning) {
  const Map memory = read_map(spec, meaning, kBudget);
  const Map disk = read_map(spec, meaning, kTinyBudget);
  ASSERT_TRUE(memory.grid.in_memory());
  ASSERT_FALSE(disk.grid.in_memory());
  EXPECT_EQ(memory.content_hash, disk.content_hash);
  EXPECT_EQ(memory.warnings, disk.warnings);
  const GridFrame& frame = memory.grid.frame();
  for (const NodeRect rect : {NodeRect{0, 0, frame.columns, frame.rows}, NodeRect{-5, -5, 40, 30},
                              NodeRect{frame.columns - 3, frame.rows - 3, 9, 9}, NodeRect{100, 50, 17, 13}}) {
    std::vector<float> a(static_cast<std::size_t>(rect.columns * rect.rows * memory.grid.channels()));
    std::vector<float> b(a.size());
    memory.grid.read_block(rect, a);
    disk.grid.read_block(rect, b);
    expect_same_bits(a, b);
  }
}

class CachedMap : public ::testing::Test {
 protected:
  static constexpr int kWidth = 310;
  static constexpr int kHeight = 270;

  template <class T>
  void write(const char* name, int channels, TypeDesc type, double scale, int tile = 0) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> value(0.0, scale);
    std::vector<T> pixels(static_cast<std::size_t>(kWidth * kHeight * channels));
    for (T& pixel : pixels) pixel = static_cast<T>(value(random));
    write_image(folder_ / name, kWidth, kHeight, channels, type, pixels, {}, tile);
  }
  MapSpec spec(const char* name) const {
    MapSpec result;
    result.file = folder_ / name;
    result.field = "map";
    result.spacing_m = 1.0;
    return result;
  }
  /// A height map with a wide gap and specks, and one without.
  void write_heights(const char* name, bool gaps) {
    std::vector<float> values;
    for (int j = 0; j < kHeight; ++j) {
      for (int i = 0; i < kWidth; ++i) {
        const bool gap = gaps && (i < 90 + j / 9 || (i * 31 + j * 17) % 211 == 0);
        values.push_back(gap ? -9999.0f : testing::rolling_height_m(i, j));
      }
    }
    write_image(folder_ / name, kWidth, kHeight, 1, TypeDesc::FLOAT, values);
  }
  TemporaryFolder folder_;
};

TEST_F(CachedMap, EveryFormatGivesTheSameBits) {
  write<std::uint8_t>("u8.png", 1, TypeDesc::UINT8, 255.0);
  write<std::uint16_t>("u16.png", 1, TypeDesc::UINT16, 65535.0);
  write<std::int16_t>("i16.tif", 1, TypeDesc::INT16, 32767.0);
  write<std::uint32_t>("u32.tif", 1, TypeDesc::UINT32, 4294967295.0);
  write<std::int32_t>("i32.tif", 1, TypeDesc::INT32, 2147483647.0);
  write<float>("f.tif", 1, TypeDesc::FLOAT, 1.0);
  write<float>("tiles.tif", 1, TypeDesc::FLOAT, 1.0, 64);
  write<float>("f.exr", 1, TypeDesc::FLOAT, 1.0);
  write<float>("h.exr", 1, TypeDesc::HALF, 1.0, 32);
  for (const char* name :
       {"u8.png", "u16.png", "i16.tif", "u32.tif", "i32.tif", "f.tif", "tiles.tif", "f.exr", "h.exr"}) {
    SCOPED_TRACE(name);
    MapSpec curved = spec(name);
    curved.curve = 1.7;
    curved.max = 900.0;
    expect_same_grids(curved, MapMeaning::kDensity);
  }
}

TEST_F(CachedMap, ColoursAndSingleChannelsToo) {
  write<std::uint8_t>("rgba.png", 4, TypeDesc::UINT8, 255.0);
  expect_same_grids(spec("rgba.png"), MapMeaning::kColor);
  MapSpec blue = spec("rgba.png");
  blue.channel = "B";
  expect_same_grids(blue, MapMeaning::kFactor);
}

TEST_F(CachedMap, GroundIsTheSameGround) {
  for (const bool gaps : {false, true}) {
    SCOPED_TRACE(gaps);
    write_heights("h.tif", gaps);
    const HeightField memory(read_map(spec("h.tif"), MapMeaning::kHeight, kBudget).grid);
    const HeightField disk(read_map(spec("h.tif"), MapMeaning::kHeight, kTinyBudget).grid);
    EXPECT_EQ(memory.range().min_m, disk.range().min_m);
    EXPECT_EQ(memory.range().max_m, disk.range().max_m);
    std::vector<float> a(200 * 150), b(a.size());
    for (const glm::dvec2 origin_m :
         {glm::dvec2(-3.0, -2.0), glm::dvec2(60.0, 70.0), glm::dvec2(215.0, 200.0)}) {
      memory.sample_lattice(origin_m, 0.7, 200, 150, a);
      disk.sample_lattice(origin_m, 0.7, 200, 150, b);
      expect_same_bits(a, b);
    }
    std::mt19937 random(2);
    std::uniform_real_distribution<double> x(0.0, kWidth - 10.0), y(0.0, kHeight - 10.0), unit(0.0, 9.0);
    for (int k = 0; k < 200; ++k) {
      const glm::dvec2 low(x(random), y(random)), high = low + glm::dvec2(unit(random), unit(random));
      EXPECT_EQ(memory.has_data(low, high), disk.has_data(low, high));
      const HeightRange range = disk.range(low, high);
      for (int n = 0; n < 5; ++n) {
        const float z = memory.height_m(low + (high - low) * glm::dvec2(unit(random), unit(random)) / 9.0);
        EXPECT_GE(z, range.min_m);
        EXPECT_LE(z, range.max_m);
      }
    }
  }
}

TEST_F(CachedMap, MayBeReadFromManyThreads) {
  write<std::uint16_t>("u16.tif", 1, TypeDesc::UINT16, 65535.0);
  const Map memory = read_map(spec("u16.tif"), MapMeaning::kDensity, kBudget);
  const Map disk = read_map(spec("u16.tif"), MapMeaning::kDensity, kTinyBudget);
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      std::mt19937 random(t);
      std::vector<float> a(400), b(400);
      for (int k = 0; k < 200; ++k) {
        const NodeRect rect{static_cast<int>(random() % 290), static_cast<int>(random() % 250), 20, 20};
        memory.grid.read_block(rect, a);
        disk.grid.read_block(rect, b);
        EXPECT_EQ(a, b);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST_F(CachedMap, AFileThatShrinksMeanwhileDoesNotMatter) {
  write<float>("f.tif", 1, TypeDesc::FLOAT, 1.0);
  const Map memory = read_map(spec("f.tif"), MapMeaning::kDensity, kBudget);
  const Map disk = read_map(spec("f.tif"), MapMeaning::kDensity, kTinyBudget);
  testing::write_text(folder_ / "f.tif", "gone");
  std::vector<float> a(100), b(100);
  memory.grid.read_block({0, 0, 10, 10}, a);
  disk.grid.read_block({0, 0, 10, 10}, b);
  expect_same_bits(a, b);
}

}  // namespace
}  // namespace prairie
