// Recorded motion: any text is a walk, or is refused with BadInput.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "agents/bvh.h"
#include "agents/gait_of_bvh.h"
#include "files/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    prairie::gait_of(prairie::parse_bvh(text, "fuzzed"));
  } catch (const prairie::BadInput&) {
  }
  return 0;
}
