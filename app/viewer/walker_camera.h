// The viewer's camera where somebody walks: free (app/viewer/fly_camera.h), behind a walker, or turning about
// it. Knows nothing of windows.
//
// Bound to a walker it looks at the walker's chest from a distance, heading and pitch of its own; all of them
// approach what is wanted exponentially, so that it glides from wherever it was and never jumps. The ground
// lifts it where it would be below.
#pragma once

#include <cstddef>
#include <optional>

#include "app/viewer/fly_camera.h"
#include "lod/camera.h"

namespace prairie {

class HeightField;
class World;

enum class CameraMode { kFree, kFollow, kOrbit };

/// "free", "follow" or "orbit".
const char* camera_mode_name(CameraMode mode);

class WalkerCamera {
 public:
  /// Watches that walker, if there is one, and follows it at once if it is present; is free otherwise.
  WalkerCamera(const Camera& start, const World& world, std::optional<std::size_t> follow);

  const Camera& camera() const { return camera_; }
  CameraMode mode() const { return mode_; }
  /// Whether it is free and keeps to the ground.
  bool walks() const { return mode_ == CameraMode::kFree && fly_.walks(); }
  /// The walker that is watched, in any mode; it need not be present any more.
  std::optional<std::size_t> watched() const { return watched_; }

  /// The size of the picture, after the window's.
  void resize(glm::ivec2 size_px);
  /// Switches between flying and walking where it is free.
  void toggle_walking(const HeightField& ground);

  /// Watches the next walker that is present, at first the one nearest to the middle of the view.
  void watch_next(const World& world);
  /// From free to behind the walker, about it, and free again where it is then. Watches somebody if nobody
  /// was.
  void change_mode(const World& world);

  /// Moves for `dt_s` seconds. About a walker, dragging turns; bound to one, the wheel and `up` change the
  /// distance, and other directions do nothing.
  void move(const Steering& steering, double dt_s, const World& world);

 private:
  /// The eye is `distance_m` behind the target along a heading and a pitch, as those of Camera.
  struct Boom {
    glm::dvec3 target_m{0.0};
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    double distance_m = 0.0;
  };

  void bind(const World& world);
  void free(const World& world);
  void steer_boom(const Steering& steering, double dt_s);
  void approach(double dt_s, const World& world);
  void look_along_boom(const World& world);

  FlyCamera fly_;
  Camera camera_;
  CameraMode mode_ = CameraMode::kFree;
  std::optional<std::size_t> watched_;
  Boom boom_;
  double wanted_distance_m_ = 0.0;
};

}  // namespace prairie
