// Measured winds: any text is a series that the wind takes, or is refused with BadInput of one line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/error.h"
#include "maps/wind_file.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  try {
    const WindFile wind = parse_wind_file({reinterpret_cast<const char*>(data), size}, "wind");
    require(!wind.times_s.empty() && wind.speeds_m_per_s.size() == wind.times_s.size() &&
            wind.headings_rad.size() == wind.times_s.size());
    for (std::size_t n = 0; n < wind.times_s.size(); ++n) {
      require(std::isfinite(wind.times_s[n]) && (n == 0 || wind.times_s[n] > wind.times_s[n - 1]));
      require(wind.speeds_m_per_s[n] >= 0.0 && wind.speeds_m_per_s[n] <= 100.0);
      require(std::isfinite(wind.headings_rad[n]));
    }
  } catch (const BadInput& fault) {
    require(fault.file == "wind");
    require(std::string_view(fault.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
