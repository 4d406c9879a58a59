// A stranger's georeferenced raster, through GDAL's door: whatever its bytes and its name, it is read or
// refused with BadInput. The first byte chooses name and meaning. A VRT finds a raster "a.tif" beside it.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "files/error.h"
#include "maps/geotiff_output.h"
#include "maps/map_file.h"

namespace prairie {
namespace {

constexpr std::uint64_t kBudget = std::uint64_t{1} << 24;

void write(const std::filesystem::path& path, const void* data, std::size_t size) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

/// In memory where the system offers that.
std::filesystem::path make_folder() {
  const std::filesystem::path memory = "/dev/shm";
  const std::filesystem::path base =
      std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  const std::filesystem::path folder = base / fmt::format("prairie_fuzz_georaster_{}", ::getpid());
  std::filesystem::create_directories(folder);
  const NodeGrid grid({8, 8, 1.0, {0.0, 0.0}, false}, 1, std::vector<float>(64, 3.0f));
  const std::vector<std::byte> source = encode_geotiff(grid, nullptr);
  write(folder / "a.tif", source.data(), source.size());
  static const struct Removal {
    std::filesystem::path folder;
    ~Removal() { std::filesystem::remove_all(folder); }
  } removal{folder};
  return folder;
}

}  // namespace
}  // namespace prairie

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  if (size < 1) return 0;
  static const std::filesystem::path folder = make_folder();
  constexpr std::array kNames{"x.tif", "x.asc", "x.vrt", "N45E014.hgt"};
  const std::filesystem::path path = folder / kNames[data[0] & 3u];
  write(path, data + 1, size - 1);
  MapSpec spec;
  spec.file = path;
  spec.field = "fuzz";
  if ((data[0] & 4u) != 0) spec.spacing_m = 1.0;
  try {
    const Map map = read_map(spec, (data[0] & 8u) != 0 ? MapMeaning::kDensity : MapMeaning::kHeight, kBudget);
    if (map.grid.frame().columns <= 0 || map.grid.frame().rows <= 0) std::abort();
  } catch (const BadInput&) {
  }
  std::filesystem::remove(path);
  return 0;
}
