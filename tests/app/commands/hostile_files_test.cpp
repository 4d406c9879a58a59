// Three hundred hostile rasters, through the program's own decoder: each is read or refused in one line that
// names it, soon, within the budget, and the next one is decoded as if nothing had happened.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <random>

#include "files/error.h"
#include "files/worker_process.h"
#include "maps/map_file.h"
#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"
#include "tests/maps/test_rasters.h"
#include "world/decoder.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

constexpr std::uint64_t kBudget = std::uint64_t{64} << 20;
constexpr double kLongestS = 5.0;
constexpr long kMostMemoryKiB = (64 + 200) * 1024;

struct Seed {
  std::string name;
  Bytes bytes;
};

Bytes of_text(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

Seed image(const TemporaryFolder& folder, const std::string& name, OIIO::TypeDesc type, int channels,
           const OIIO::ParamValueList& attributes = {}, int tile = 0) {
  constexpr int kSide = 48;
  std::vector<float> pixels;
  for (int k = 0; k < kSide * kSide * channels; ++k)
    pixels.push_back(static_cast<float>(k * 7919 % 997) / 997.0f);
  testing::write_image(folder / name, kSide, kSide, channels, type, pixels, attributes, tile);
  return {name, testing::read_bytes(folder / name)};
}

Seed georaster(const TemporaryFolder& folder, const std::string& name, const std::string& driver,
               std::vector<std::string> options) {
  testing::RasterPlan plan;
  plan.driver = driver;
  plan.options = std::move(options);
  plan.columns = plan.rows = 64;
  plan.place = testing::north_up(1.0, 500'000.0, 4'500'000.0, 64);
  plan.system = "EPSG:32614";
  plan.nodata = -9999.0;
  testing::write_georaster(folder / name, plan, [](int column, int row, int) { return column * 0.5 + row; });
  return {name, testing::read_bytes(folder / name)};
}

std::vector<Seed> seeds(const TemporaryFolder& folder) {
  using OIIO::TypeDesc;
  OIIO::ParamValueList progressive, profile, turned;
  progressive.attribute("jpeg:progressive", 1);
  const std::vector<std::uint8_t> icc(200, 3);
  profile.attribute("ICCProfile", TypeDesc(TypeDesc::UINT8, static_cast<int>(icc.size())), icc.data());
  turned.attribute("Orientation", 6);
  std::vector<Seed> seeds{
      image(folder, "grey.png", TypeDesc::UINT8, 1),
      image(folder, "deep.png", TypeDesc::UINT16, 3),
      image(folder, "plain.jpg", TypeDesc::UINT8, 3),
      image(folder, "progressive.jpg", TypeDesc::UINT8, 3, progressive),
      image(folder, "profile.jpg", TypeDesc::UINT8, 3, profile),
      image(folder, "a.tga", TypeDesc::UINT8, 4),
      image(folder, "a.bmp", TypeDesc::UINT8, 3),
      image(folder, "a.hdr", TypeDesc::FLOAT, 3),
      image(folder, "lines.exr", TypeDesc::HALF, 1),
      image(folder, "tiles.exr", TypeDesc::FLOAT, 3, {}, 16),
      image(folder, "turned.tif", TypeDesc::UINT8, 1, turned),
      georaster(folder, "strips.tif", "GTiff", {"COMPRESS=LZW"}),
      georaster(folder, "tiles.tif", "GTiff",
                {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "COMPRESS=DEFLATE"}),
      georaster(folder, "big.tif", "GTiff", {"BIGTIFF=YES"}),
      georaster(folder, "cloud.tif", "COG", {}),
      georaster(folder, "grid.asc", "AAIGrid", {}),
  };
  seeds.push_back({"N45E014.hgt", Bytes(std::size_t{1201} * 1201 * 2, std::byte{1})});
  seeds.push_back({"a.r16", Bytes(std::size_t{64} * 64 * 2, std::byte{7})});
  seeds.push_back(
      {"a.vrt",
       of_text(R"(<VRTDataset rasterXSize="64" rasterYSize="64"><GeoTransform>0,1,0,64,0,-1</GeoTransform>)"
               R"(<VRTRasterBand dataType="Float32" band="1"><SimpleSource>)"
               R"(<SourceFilename relativeToVRT="1">strips.tif</SourceFilename><SourceBand>1</SourceBand>)"
               R"(</SimpleSource></VRTRasterBand></VRTDataset>)")});
  return seeds;
}

/// Sets `count` bytes from `at` on.
void fill(Bytes& bytes, std::size_t at, std::size_t count, std::byte value) {
  for (std::size_t k = at; k < std::min(at + count, bytes.size()); ++k) bytes[k] = value;
}

/// Cut off, claiming, pointing in circles and beyond, scribbled over.
std::vector<Bytes> hostile_versions(const Bytes& whole, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Bytes> versions;
  for (const double share : {0.0, 0.02, 0.3, 0.7, 0.99}) {
    versions.emplace_back(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(
                                                             share * static_cast<double>(whole.size())));
  }
  const std::size_t head = std::min<std::size_t>(whole.size(), 512);
  for (int k = 0; k < 4; ++k) {  // claims
    versions.push_back(whole);
    fill(versions.back(), random() % head, 4, k % 2 == 0 ? std::byte{0xff} : std::byte{0x7f});
  }
  for (const std::size_t at : {std::size_t{4}, whole.size() / 2}) {  // loops and offsets, as of directories
    versions.push_back(whole);
    fill(versions.back(), at, 8, std::byte{0});
    fill(versions.back(), at, 1, std::byte{8});
  }
  for (const std::size_t count : {std::size_t{1}, std::size_t{16}, std::size_t{256}}) {
    versions.push_back(whole);
    for (std::size_t k = 0; k < count; ++k)
      versions.back()[random() % whole.size()] = static_cast<std::byte>(random() % 256);
  }
  versions.push_back(whole);
  versions.back().insert(versions.back().end(), 1000, std::byte{0xaa});
  versions.push_back(Bytes(whole.size(), std::byte{'x'}));
  return versions;
}

/// Decodes; returns what was said against it, empty where it was read.
std::string complaint(const fs::path& file, WorkerProcess& decoder) {
  MapSpec spec;
  spec.file = file;
  spec.field = "species.0.density.file";
  spec.spacing_m = 1.0;
  spec.channel = "1";
  if (file.extension() == ".r16") spec.size_px = {64, 64};
  try {
    read_map(spec, MapMeaning::kDensity, kBudget, nullptr, &decoder);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(HostileFiles, AreReadOrRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::vector<Seed> all = seeds(folder);
  auto decoder = std::make_unique<WorkerProcess>(PRAIRIE_PROGRAM, kDecodeArgument);
  std::string faults;
  int files = 0, refused = 0, ended = 0;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const fs::path file = folder / all[s].name;
    testing::write_bytes(file, all[s].bytes);
    EXPECT_EQ(complaint(file, *decoder), "") << all[s].name;
    for (const Bytes& bytes : hostile_versions(all[s].bytes, static_cast<unsigned>(s))) {
      testing::write_bytes(file, bytes);
      const auto start = std::chrono::steady_clock::now();
      const std::string said = complaint(file, *decoder);
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      EXPECT_LT(elapsed.count(), kLongestS) << all[s].name << ", version " << files;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      if (!said.empty()) {
        EXPECT_NE(said.find(all[s].name), std::string::npos) << said;
        ++refused;
      }
      if (said.find("its decoder") != std::string::npos) {
        ++ended;
        faults += said + '\n';
      }
      ++files;
    }
    testing::write_bytes(file, all[s].bytes);
    EXPECT_EQ(complaint(file, *decoder), "") << "after hostile versions of " << all[s].name;
  }
  EXPECT_GE(files, 300);
  EXPECT_GT(refused, files / 2);
  RecordProperty("files", files);
  RecordProperty("refused", refused);
  RecordProperty("ended_their_decoder", ended);
  RecordProperty("faults_of_libraries", faults);
  decoder.reset();
#if !defined(__SANITIZE_ADDRESS__)
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  EXPECT_LT(usage.ru_maxrss, kMostMemoryKiB);
  RecordProperty("largest_decoder_KiB", static_cast<int>(usage.ru_maxrss));
#endif
}

/// A colour profile whose text claims 3 bytes where 8 come before its letters.
Bytes jpeg_with_short_profile_text(const TemporaryFolder& folder) {
  std::string icc(132, '\0');
  const auto u32 = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift));
    return bytes;
  };
  icc.replace(8, 4, u32(0x02400000)).replace(12, 8, "mntrRGB ").replace(36, 4, "acsp");
  icc.replace(128, 4, u32(1));
  icc += "desc" + u32(144) + u32(3);
  icc += "des";
  icc.replace(0, 4, u32(static_cast<std::uint32_t>(icc.size())));
  OIIO::ParamValueList profile;
  profile.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(icc.size())),
                    icc.data());
  testing::write_image(folder / "icc.jpg", 8, 8, 1, OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>(64, 9),
                       profile);
  return testing::read_bytes(folder / "icc.jpg");
}

TEST(HostileFiles, EndTheDecoderAndNotTheProgram) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "icc.jpg", jpeg_with_short_profile_text(folder));
  const testing::Outcome outcome = testing::prairie(
      {"new", (folder / "a").string(), "--density", (folder / "icc.jpg").string(), "--density-spacing", "1"});
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.exit_code << outcome.err;
  if (outcome.exit_code == 3) {
    EXPECT_NE(outcome.err.find("icc.jpg"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "a"));
  }
}

}  // namespace
}  // namespace prairie
