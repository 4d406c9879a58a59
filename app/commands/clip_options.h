// What `record` and `walk` are both told of the clips that they draw. What the options set must live as long
// as the command.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/state_options.h"
#include "app/outputs/clip.h"
#include "app/outputs/recording.h"
#include "app/scenes/camera_path.h"
#include "lod/frame_plan.h"

namespace prairie {

class World;

struct ClipOptions {
  ClipFormat format;
  std::optional<std::string> camera;
  std::filesystem::path path;  // of the file of a camera's path; none: the camera stands
  std::optional<double> duration_s;
  Tier tier = Tier::kAuto;
  int samples = 1;
  std::optional<double> parallel_height_m;
  StateOptions state;

  std::string camera_or_default() const;
};

/// `--camera`
CommandOption clip_camera_option(ClipOptions& options);
/// `--path`, for a line with `--camera` before it
CommandOption clip_path_option(ClipOptions& options, const std::string& help, const char* needs = nullptr);
/// `--duration`
CommandOption clip_duration_option(ClipOptions& options, const std::string& help);
/// `--fps`
CommandOption clip_rate_option(ClipOptions& options, const std::string& help);

/// The path that is asked for, if one is. Throws BadInput.
std::optional<CameraPath> asked_camera_path(const ClipOptions& options);

/// As long as is asked for; else, as the path; else, `otherwise_s`.
double asked_duration_s(const ClipOptions& options, const std::optional<CameraPath>& path,
                        double otherwise_s);
inline constexpr double kUsualDurationS = 10.0;

/// Throws UsageError where the scene has no such camera.
ClipView asked_view(const ClipOptions& options, const std::optional<CameraPath>& path, const World& world);

}  // namespace prairie
