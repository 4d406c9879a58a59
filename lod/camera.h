// A pinhole camera in the scene, and the transforms that follow from it. Positions in double, directions in
// float.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace prairie {

/// How near the near plane is, for an eye so high above the ground: it must not cut the ground open before an
/// eye among the roots, nor need blades be drawn that hang before a standing person's eye. Depth is reversed
/// and of 32 bits, which lose nothing by it.
double near_plane_m(double eye_above_ground_m);

struct Camera {
  glm::dvec3 eye_m{0.0};
  double yaw_rad = 0.0;                 // 0 looks north (+y), clockwise
  double pitch_rad = 0.0;               // up positive
  double fov_rad = 1.0471975511965976;  // vertical; ignored when orthographic
  double orthographic_height_m = 0.0;   // > 0: parallel projection of this height
  glm::ivec2 size_px{800, 600};
  double near_m = 0.05;
  double orthographic_depth_m = 4000.0;  // how far a parallel projection reaches from the eye

  glm::dvec3 forward() const;
  glm::dvec3 right() const;
  glm::dvec3 up() const;
  bool is_orthographic() const { return orthographic_height_m > 0.0; }
  /// Height of one pixel at distance 1 m (perspective), or anywhere (orthographic), metres.
  double pixel_m() const;
  /// Height of one pixel at a distance, metres.
  double pixel_m_at(double distance_m) const;
  /// Clip space (z in [0, w], reversed: depth 1 at the near plane, 0 at infinity) from the frame whose origin
  /// is the eye and whose axes are the scene's.
  glm::mat4 clip_from_eye() const;
};

}  // namespace prairie
