// Paths of a camera: any text is a path with finite cameras at all times, or is refused with BadInput of one
// line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "app/scenes/camera_path.h"
#include "files/error.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  try {
    const CameraPath path = parse_camera_path({reinterpret_cast<const char*>(data), size}, "path");
    require(!path.times_s.empty() && path.cameras.size() == path.times_s.size());
    for (const double share : {-0.1, 0.0, 0.01, 0.3, 0.5, 0.77, 1.0, 1.1}) {
      const double time_s = path.times_s.front() + share * (path.times_s.back() - path.times_s.front());
      const CameraSpec camera = camera_at(path, time_s);
      require(std::isfinite(camera.position_m.x) && std::isfinite(camera.position_m.y));
      require(std::isfinite(camera.z_m) && std::isfinite(camera.yaw_deg));
      require(std::abs(camera.pitch_deg) <= 90.0 && camera.fov_deg > 0.0);
    }
  } catch (const BadInput& fault) {
    require(fault.file == "path");
    require(std::string_view(fault.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
