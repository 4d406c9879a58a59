// Somebody's state file: whatever its bytes, it is taken over, and then is what is saved again, or refused
// with BadInput, and then nothing has changed. The checksum would keep nearly all mutations from the reader
// behind it, so that the first byte may ask for a header that fits.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "files/error.h"
#include "tests/fuzz/state_worlds.h"
#include "world/state_file.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  using fuzz::StateInput;
  if (size < 1) return 0;
  static World world = fuzz::calm_world();
  static const std::vector<std::byte> start = world.saved_state();
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  std::vector<std::byte> file(bytes + 1, bytes + size);
  if (data[0] == static_cast<std::uint8_t>(StateInput::kBody)) {
    file.insert(file.begin(), start.begin(), start.begin() + kStateHeaderBytes);
    seal_state(file);
  }
  try {
    world.load_state(file, "state");
  } catch (const BadInput& fault) {
    require(fault.file == "state");
    require(std::string_view(fault.what()).find('\n') == std::string_view::npos);
    require(world.saved_state() == start);
    return 0;
  }
  require(world.saved_state() == file);
  world.step(1.0 / 60.0);
  world.load_state(start, "start");
  return 0;
}
