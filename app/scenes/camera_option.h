// `--camera`: the name of one of the scene's cameras, or a place and a direction typed in.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "lod/camera.h"
#include "world/scene/scene.h"

namespace prairie {

class World;

/// The camera that is used where none is asked for.
inline constexpr const char* kDefaultCamera = "default";
/// Beyond it, positions in double have no millimetres to spare for the maths.
inline constexpr double kFarthestCameraM = 1e7;
inline constexpr double kMinFieldOfViewDeg = 1.0;
inline constexpr double kMaxFieldOfViewDeg = 170.0;

/// "x,y,z,yaw,pitch[,fov]" in metres and degrees; a z with a sign ("+1.7") counts from the ground. Anything
/// without a comma is the name of one of the scene's cameras. Throws UsageError.
CameraSpec camera_option(const std::string& text, const World& world);

/// The camera where the spec puts it above the world's ground.
Camera placed_camera(const CameraSpec& spec, const World& world, glm::ivec2 size_px);

}  // namespace prairie
