// `--path`: where a camera is at which time, as comma-separated text, and the smooth way between.
//
// Columns, in any order: `time_s`, rising, from the clip's start; `x_m`, `y_m`; `z_m`, absolute or in all
// rows with a sign
// ("+1.7") above the ground; `yaw_deg`, `pitch_deg`; and, if one likes, `fov_deg`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "world/scene/scene.h"

namespace prairie {

struct CameraPath {
  std::vector<double> times_s;
  std::vector<CameraSpec> cameras;  // one for each time; yaw turns the shorter way from one to the next
};

/// Throws BadInput that names line, column, what was found and what was expected. `name`: of the file, for
/// messages.
CameraPath parse_camera_path(std::string_view text, const std::string& name);

/// Throws BadInput, also where the file cannot be read or is larger than 16 MiB.
CameraPath read_camera_path(const std::filesystem::path& path);

/// On cubics through the rows whose slope at each is that of the parabola through it and its neighbours
/// (Catmull-Rom, for times that need not be evenly spaced); heights above the ground stay between those of
/// the rows before and after. Before the first row and after the last the camera stands still.
CameraSpec camera_at(const CameraPath& path, double time_s);

}  // namespace prairie
