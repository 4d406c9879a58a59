#include "app/scenes/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "app/scenes/camera_option.h"
#include "files/csv_table.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr const char* kColumns = "columns time_s, x_m, y_m, z_m, yaw_deg, pitch_deg and perhaps fov_deg";

// What changes along a path, as numbers of equal standing.
using Values = std::array<double, 6>;
constexpr std::size_t kHeight = 2;

Values values_of(const CameraSpec& camera) {
  return {camera.position_m.x, camera.position_m.y, camera.z_m,
          camera.yaw_deg,      camera.pitch_deg,    camera.fov_deg};
}

// Differences over time between a row and the next; none beyond the ends.
double slope_between(const CameraPath& path, std::size_t row, std::size_t value) {
  return (values_of(path.cameras[row + 1])[value] - values_of(path.cameras[row])[value]) /
         (path.times_s[row + 1] - path.times_s[row]);
}

double slope_at(const CameraPath& path, std::size_t row, std::size_t value) {
  const std::size_t last = path.cameras.size() - 1;
  if (row == 0) return slope_between(path, 0, value);
  if (row == last) return slope_between(path, last - 1, value);
  const double before_s = path.times_s[row] - path.times_s[row - 1];
  const double after_s = path.times_s[row + 1] - path.times_s[row];
  const double before = slope_between(path, row - 1, value), after = slope_between(path, row, value);
  const double slope = (before * after_s + after * before_s) / (before_s + after_s);
  if (value != kHeight || !path.cameras[row].z_above_ground) return slope;
  // Between two rows the eye keeps to the heights of both: a cubic is monotone where its slopes are at most
  // three times the chord's (Fritsch and Carlson 1980, Monotone Piecewise Cubic Interpolation). Else it would
  // dive below the ground beside a row near to it.
  if (!(before * after > 0.0)) return 0.0;
  const double most = 3.0 * std::min(std::abs(before), std::abs(after));
  return std::clamp(slope, -most, most);
}

}  // namespace

CameraPath parse_camera_path(std::string_view text, const std::string& name) {
  CsvTable table(text, name);
  const std::size_t time = table.need("time_s", kColumns);
  const std::size_t x = table.need("x_m", kColumns), y = table.need("y_m", kColumns),
                    z = table.need("z_m", kColumns);
  const std::size_t yaw = table.need("yaw_deg", kColumns), pitch = table.need("pitch_deg", kColumns);
  const std::optional<std::size_t> fov = table.find("fov_deg");

  CameraPath path;
  while (table.next_row()) {
    const double time_s = table.number(time, 0.0, 1e9);
    if (!path.times_s.empty() && time_s <= path.times_s.back())
      table.refuse(time, fmt::format("a time after {}", path.times_s.back()));
    CameraSpec camera;
    camera.position_m = {table.number(x, -kFarthestCameraM, kFarthestCameraM),
                         table.number(y, -kFarthestCameraM, kFarthestCameraM)};
    camera.z_m = table.number(z, -kFarthestCameraM, kFarthestCameraM);
    camera.z_above_ground = table.cell(z).starts_with('+');
    camera.yaw_deg = table.number(yaw, -3600.0, 3600.0);
    camera.pitch_deg = table.number(pitch, -90.0, 90.0);
    if (fov) camera.fov_deg = table.number(*fov, kMinFieldOfViewDeg, kMaxFieldOfViewDeg);
    if (!path.cameras.empty()) {
      const CameraSpec& before = path.cameras.back();
      if (camera.z_above_ground != before.z_above_ground)
        table.refuse(z, before.z_above_ground ? "a height above the ground (\"+1.7\"), as in the rows before"
                                              : "an absolute height, as in the rows before");
      camera.yaw_deg = before.yaw_deg + std::remainder(camera.yaw_deg - before.yaw_deg, 360.0);
    }
    path.times_s.push_back(time_s);
    path.cameras.push_back(camera);
  }
  if (path.times_s.empty()) throw BadInput(name, "", "no row", "at least one line of numbers");
  return path;
}

CameraPath read_camera_path(const std::filesystem::path& path) {
  return parse_camera_path(read_text_input(path, "--path", kMostBytes), path.string());
}

CameraSpec camera_at(const CameraPath& path, double time_s) {
  const auto next = std::ranges::upper_bound(path.times_s, time_s);
  if (next == path.times_s.begin()) return path.cameras.front();
  if (next == path.times_s.end()) return path.cameras.back();
  const auto row = static_cast<std::size_t>(std::distance(path.times_s.begin(), next)) - 1;
  const double interval_s = path.times_s[row + 1] - path.times_s[row];
  const double t = (time_s - path.times_s[row]) / interval_s;
  const Values from = values_of(path.cameras[row]), to = values_of(path.cameras[row + 1]);
  Values at{};
  for (std::size_t value = 0; value < at.size(); ++value) {
    // Hermite's four weights.
    at[value] = from[value] * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) + to[value] * t * t * (3.0 - 2.0 * t) +
                interval_s * t * (1.0 - t) *
                    (slope_at(path, row, value) * (1.0 - t) - slope_at(path, row + 1, value) * t);
  }
  CameraSpec camera = path.cameras[row];
  camera.position_m = {at[0], at[1]};
  camera.z_m = at[2];
  camera.yaw_deg = at[3];
  camera.pitch_deg = std::clamp(at[4], -90.0, 90.0);
  camera.fov_deg = std::clamp(at[5], kMinFieldOfViewDeg, kMaxFieldOfViewDeg);
  return camera;
}

}  // namespace prairie
