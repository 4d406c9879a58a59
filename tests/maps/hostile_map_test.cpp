// Files that are broken or lie: each is refused with one line that names it, quickly, and without spending
// memory.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string_view>

#include "files/error.h"
#include "maps/map_file.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

using OIIO::TypeDesc;

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;
constexpr long kMaxResident_kB = 512 * 1024;

MapSpec spec_of(const std::filesystem::path& file) {
  MapSpec spec;
  spec.file = file;
  spec.field = "layers.map";
  spec.spacing_m = 1.0;
  return spec;
}

void expect_refused(const std::filesystem::path& file) {
  SCOPED_TRACE(file);
  const auto start = std::chrono::steady_clock::now();
  try {
    read_map(spec_of(file), MapMeaning::kDensity, kBudget);
    ADD_FAILURE() << "was read";
  } catch (const BadInput& fault) {
    const std::string line = fault.what();
    for (const std::string& part : {file.string(), std::string("layers.map"), std::string("expected")}) {
      EXPECT_NE(line.find(part), std::string::npos) << line;
    }
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_FALSE(fault.found.empty());
  }
  const std::chrono::duration<double> elapsed_s = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed_s.count(), 5.0);
#if !defined(__SANITIZE_ADDRESS__)
  // The highest so far in this process, whatever ran before.
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, kMaxResident_kB);
#endif
}

class HostileMap : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(HostileMap, WhatIsNoImage) {
  testing::write_text(folder_ / "empty.png", "");
  testing::write_text(folder_ / "text.png", "this is not an image, whatever it is called\n");
  testing::write_text(folder_ / "text.tif", std::string(100000, 'x'));
  testing::write_text(folder_ / "text.xyz", "no format at all");
  std::filesystem::create_directory(folder_ / "folder.png");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  for (const char* name :
       {"empty.png", "text.png", "text.tif", "text.xyz", "folder.png", "pipe.png", "missing.png"}) {
    expect_refused(folder_ / name);
  }
}

TEST_F(HostileMap, ClaimsOfMorePixelsThanTheFileCanHold) {
  for (const bool interlaced : {false, true}) {
    testing::write_bytes(folder_ / "bomb.png", testing::png_bomb(40000, 40000, interlaced));
    ASSERT_LT(std::filesystem::file_size(folder_ / "bomb.png"), 400u);
    expect_refused(folder_ / "bomb.png");
    testing::write_bytes(folder_ / "wide.png", testing::png_bomb(0x7fffffff, 1, interlaced));
    expect_refused(folder_ / "wide.png");
    testing::write_bytes(folder_ / "none.png", testing::png_bomb(0, 4, interlaced));
    expect_refused(folder_ / "none.png");
    testing::write_bytes(folder_ / "small.png", testing::png_bomb(400, 400, interlaced));
    expect_refused(folder_ / "small.png");
  }
}

TEST_F(HostileMap, FilesThatBreakOff) {
  std::vector<float> pixels(100 * 100);
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = static_cast<float>(k * 7919 % 1000) / 1000.0f;
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.bmp", "a.tga"}) {
    const bool floating = std::string(name) == "a.tif" || std::string(name) == "a.exr";
    testing::write_image(folder_ / name, 100, 100, 1, floating ? TypeDesc::FLOAT : TypeDesc::UINT8, pixels);
    const std::vector<std::byte> bytes = testing::read_bytes(folder_ / name);
    ASSERT_NO_THROW(read_map(spec_of(folder_ / name), MapMeaning::kDensity, kBudget)) << name;
    for (const double share : {0.01, 0.1, 0.5, 0.9}) {
      const std::size_t count = static_cast<std::size_t>(static_cast<double>(bytes.size()) * share);
      testing::write_bytes(folder_ / name, std::span(bytes).first(count));
      expect_refused(folder_ / name);
    }
  }
}

TEST_F(HostileMap, AnExrAttributeLargerThanItsFile) {
  testing::write_image<float>(folder_ / "a.exr", 4, 4, 1, TypeDesc::FLOAT, std::vector<float>(16, 1.0f));
  std::vector<std::byte> bytes = testing::read_bytes(folder_ / "a.exr");
  constexpr std::string_view kDate("capDate\0string\0", 15);
  const auto found = std::search(bytes.begin(), bytes.end(), kDate.begin(), kDate.end(),
                                 [](std::byte a, char b) { return a == static_cast<std::byte>(b); });
  ASSERT_NE(found, bytes.end());
  const std::size_t size = static_cast<std::size_t>(found - bytes.begin()) + kDate.size();
  for (const std::byte high : {std::byte{0x7f}, std::byte{0xff}}) {
    for (std::size_t k = 0; k < 4; ++k) bytes[size + k] = k == 3 ? high : std::byte{0xe0};
    testing::write_bytes(folder_ / "a.exr", bytes);
    expect_refused(folder_ / "a.exr");
  }
}

TEST_F(HostileMap, AJpeg2000ThatClaimsTooMuch) {
  // SOC, SIZ: 60000 × 60000 pixels of one component in one tile; then nothing of what must follow.
  std::string bytes("\xff\x4f\xff\x51\0\x29\0\0", 8);
  for (int pair = 0; pair < 2; ++pair) {
    bytes += std::string("\0\0\xea\x60\0\0\xea\x60", 8) + std::string(8, '\0');
  }
  bytes += std::string("\0\x01\x07\x01\x01", 5) + std::string(400, '\0');
  testing::write_text(folder_ / "a.j2k", bytes);
  expect_refused(folder_ / "a.j2k");
}

TEST_F(HostileMap, AGifThatClaimsTooMuch) {
  testing::write_text(folder_ / "a.gif", "GIF89a\xff\xff\xff\xff" + std::string(900, ' '));
  expect_refused(folder_ / "a.gif");
}

TEST_F(HostileMap, NothingButNodata) {
  testing::write_image<float>(folder_ / "n.tif", 3, 1, 1, TypeDesc::FLOAT,
                              {-9999.0f, std::numeric_limits<float>::quiet_NaN(), -3.4e38f});
  expect_refused(folder_ / "n.tif");
}

TEST_F(HostileMap, TooManyChannels) {
  testing::write_image<float>(folder_ / "c.tif", 2, 2, 17, TypeDesc::FLOAT,
                              std::vector<float>(2 * 2 * 17, 1.0f));
  expect_refused(folder_ / "c.tif");
}

TEST_F(HostileMap, LibrariesStaySilent) {
  testing::write_text(folder_ / "text.tif", std::string("II*\0\x08\0\0\0", 8) + std::string(1000, 'x'));
  testing::write_bytes(folder_ / "bomb.png", testing::png_bomb(300, 300, false));
  ::testing::internal::CaptureStderr();
  for (const char* name : {"text.tif", "bomb.png"}) {
    EXPECT_THROW(read_map(spec_of(folder_ / name), MapMeaning::kDensity, kBudget), BadInput);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace prairie
