#include "lod/camera.h"

#include <algorithm>
#include <cmath>

namespace prairie {

double near_plane_m(double eye_above_ground_m) {
  constexpr double kLeastM = 0.002, kMostM = 0.05;
  constexpr double kShareOfHeight = 0.25;  // the corners of a wide picture's plane are twice as far
  return std::clamp(kShareOfHeight * eye_above_ground_m, kLeastM, kMostM);
}

glm::dvec3 Camera::forward() const {
  return {std::sin(yaw_rad) * std::cos(pitch_rad), std::cos(yaw_rad) * std::cos(pitch_rad),
          std::sin(pitch_rad)};
}

glm::dvec3 Camera::right() const {
  return {std::cos(yaw_rad), -std::sin(yaw_rad), 0.0};
}

glm::dvec3 Camera::up() const {
  return {-std::sin(yaw_rad) * std::sin(pitch_rad), -std::cos(yaw_rad) * std::sin(pitch_rad),
          std::cos(pitch_rad)};
}

double Camera::pixel_m() const {
  if (is_orthographic()) return orthographic_height_m / size_px.y;
  return 2.0 * std::tan(0.5 * fov_rad) / size_px.y;
}

double Camera::pixel_m_at(double distance_m) const {
  return is_orthographic() ? pixel_m() : pixel_m() * distance_m;
}

glm::mat4 Camera::clip_from_eye() const {
  const double aspect = static_cast<double>(size_px.x) / size_px.y;
  const glm::dvec3 axes[3] = {right(), up(), forward()};
  // Rows of clip_from_eye; w = 1 for the parallel projection, distance along the view for the other.
  glm::dvec4 x, y, z, w;
  if (is_orthographic()) {
    const double half_m = 0.5 * orthographic_height_m;
    x = glm::dvec4(axes[0] / (half_m * aspect), 0.0);
    y = glm::dvec4(axes[1] / half_m, 0.0);
    z = glm::dvec4(-axes[2] / orthographic_depth_m, 1.0);
    w = glm::dvec4(0.0, 0.0, 0.0, 1.0);
  } else {
    const double half = std::tan(0.5 * fov_rad);
    x = glm::dvec4(axes[0] / (half * aspect), 0.0);
    y = glm::dvec4(axes[1] / half, 0.0);
    z = glm::dvec4(0.0, 0.0, 0.0, near_m);
    w = glm::dvec4(axes[2], 0.0);
  }
  glm::mat4 clip;
  for (int column = 0; column < 4; ++column) {
    clip[column] = glm::vec4(glm::dvec4(x[column], y[column], z[column], w[column]));
  }
  return clip;
}

}  // namespace prairie
