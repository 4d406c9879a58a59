// A stranger's raster: whatever its bytes, it is read or refused with BadInput. The first byte chooses how it
// is asked for.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "files/error.h"
#include "maps/height_field.h"
#include "maps/map_file.h"

namespace prairie {
namespace {

constexpr std::uint64_t kBudget = std::uint64_t{1} << 26;
constexpr std::uint64_t kTinyBudget = 1 << 12;  // sends nearly everything to a temporary file

/// In memory where the system offers that; named after no format, so that the contents decide.
std::filesystem::path input_path() {
  const std::filesystem::path memory = "/dev/shm";
  const std::filesystem::path folder =
      std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / fmt::format("prairie_fuzz_{}", ::getpid());
}

void require(bool condition) {
  if (!condition) std::abort();
}

void use(const Map& map, MapMeaning meaning) {
  const GridFrame& frame = map.grid.frame();
  require(frame.columns > 0 && frame.rows > 0 && frame.spacing_m > 0.0 && std::isfinite(frame.spacing_m));
  std::vector<float> block(8 * 8 * static_cast<std::size_t>(map.grid.channels()));
  map.grid.read_block({-2, -2, 8, 8}, block);
  map.grid.read_block({frame.columns - 4, frame.rows - 4, 8, 8}, block);
  if (meaning == MapMeaning::kDensity) {
    for (const float value : block) require(std::isnan(value) || (value >= 0.0f && value <= 100.0f));
  }
  if (meaning == MapMeaning::kHeight) {
    const HeightField ground(map.grid);
    require(std::isfinite(ground.height_m({1.0, 1.0})));
  }
}

}  // namespace
}  // namespace prairie

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  if (size < 1) return 0;
  static const std::filesystem::path path = input_path();
  {
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  }
  const unsigned choice = data[0];
  MapSpec spec;
  spec.file = path;
  spec.field = "fuzz";
  spec.max = 100.0;
  if ((choice & 4) != 0) spec.spacing_m = 1.0;
  if ((choice & 8) != 0) spec.channel = "R";
  if ((choice & 16) != 0) spec.range = {{0.0, 200.0}};
  if ((choice & 32) != 0) spec.repeats = true;
  const MapMeaning meaning = static_cast<MapMeaning>(choice & 3);
  try {
    use(read_map(spec, meaning, (choice & 64) != 0 ? kTinyBudget : kBudget), meaning);
  } catch (const BadInput&) {
  }
  std::filesystem::remove(path);
  return 0;
}
