// The texts that come along with a raster: world files and nodata values. Any text is a number (or six) or is
// none.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "files/decimal.h"
#include "maps/world_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  prairie::parse_world_file(text);
  prairie::parse_decimal(text);
  return 0;
}
