#include "app/commands/clip_options.h"

#include "app/outputs/frame_run.h"
#include "app/scenes/camera_option.h"

namespace prairie {

std::string ClipOptions::camera_or_default() const {
  return camera.value_or(kDefaultCamera);
}

CommandOption clip_camera_option(ClipOptions& options) {
  return {.names = "--camera",
          .type = "NAME|NUMBERS",
          .help = "Where it stands: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)",
          .target = text_into(options.camera)};
}

CommandOption clip_path_option(ClipOptions& options, const std::string& help, const char* needs) {
  return {.names = "--path",
          .type = "FILE.csv",
          .help = help,
          .target = text_into(options.path),
          .needs = needs,
          .excludes = "--camera"};
}

CommandOption clip_duration_option(ClipOptions& options, const std::string& help) {
  constexpr double kLongestS = 86'400.0;
  return {.names = "--duration",
          .type = "S",
          .help = help,
          .target = number_into(options.duration_s, 0.0, kLongestS)};
}

CommandOption clip_rate_option(ClipOptions& options, const std::string& help) {
  return {.names = "--fps",
          .type = "N",
          .help = help,
          .target = parsed_into(options.format.frame_rate, prairie::frame_rate_option)};
}

std::optional<CameraPath> asked_camera_path(const ClipOptions& options) {
  if (options.path.empty()) return std::nullopt;
  return read_camera_path(options.path);
}

double asked_duration_s(const ClipOptions& options, const std::optional<CameraPath>& path,
                        double otherwise_s) {
  if (options.duration_s) return *options.duration_s;
  return path ? path->times_s.back() : otherwise_s;
}

ClipView asked_view(const ClipOptions& options, const std::optional<CameraPath>& path, const World& world) {
  const CameraSpec standing = path ? CameraSpec{} : camera_option(options.camera_or_default(), world);
  return {path, standing, options.tier, options.samples, options.parallel_height_m};
}

}  // namespace prairie
