#include "app/scenes/camera_option.h"

#include <glm/trigonometric.hpp>
#include <vector>

#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "files/joined.h"
#include "world/camera_placement.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr const char* kOption = "--camera";

CameraSpec typed_camera(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 5 && parts.size() != 6) {
    throw UsageError(kOption, text, "x,y,z,yaw,pitch[,fov] (metres, degrees) or the name of a camera");
  }
  const auto part = [&](std::size_t k, const char* name, double least, double most) {
    return number_option(std::string(kOption) + " " + name, parts[k], least, most);
  };
  CameraSpec spec;
  spec.position_m = {part(0, "x", -kFarthestCameraM, kFarthestCameraM),
                     part(1, "y", -kFarthestCameraM, kFarthestCameraM)};
  spec.z_m = part(2, "z", -kFarthestCameraM, kFarthestCameraM);
  spec.z_above_ground = parts[2].starts_with('+');
  spec.yaw_deg = part(3, "yaw", -3600.0, 3600.0);
  spec.pitch_deg = part(4, "pitch", -90.0, 90.0);
  if (parts.size() == 6) spec.fov_deg = part(5, "fov", kMinFieldOfViewDeg, kMaxFieldOfViewDeg);
  return spec;
}

CameraSpec named_camera(const std::string& name, const World& world) {
  std::vector<std::string> names;
  for (const CameraSpec& camera : world.scene().cameras) {
    if (camera.name == name) return camera;
    names.push_back(camera.name);
  }
  // A scene need not have cameras; where none is asked for, one is found.
  if (names.empty() && name == kDefaultCamera) return placed_camera_spec(world.meadow(), name);
  if (names.empty())
    throw UsageError(kOption, name, "x,y,z,yaw,pitch[,fov], since the scene names no camera");
  throw UsageError(kOption, name + did_you_mean(name, names),
                   "x,y,z,yaw,pitch[,fov] or one of the scene's cameras: " + joined(names, ", "));
}

}  // namespace

CameraSpec camera_option(const std::string& text, const World& world) {
  return text.find(',') == std::string::npos ? named_camera(text, world) : typed_camera(text);
}

Camera placed_camera(const CameraSpec& spec, const World& world, glm::ivec2 size_px) {
  const double ground_m =
      spec.z_above_ground ? static_cast<double>(world.meadow().ground.height_m(spec.position_m)) : 0.0;
  Camera camera;
  camera.eye_m = {spec.position_m, ground_m + spec.z_m};
  camera.yaw_rad = glm::radians(spec.yaw_deg);
  camera.pitch_rad = glm::radians(spec.pitch_deg);
  camera.fov_rad = glm::radians(spec.fov_deg);
  camera.size_px = size_px;
  return camera;
}

}  // namespace prairie
