// The viewer's camera, moved by keys and mouse: flying freely, or walking with its eyes at a fixed height
// above the ground. Knows nothing of windows.
#pragma once

#include "lod/camera.h"
#include "maps/height_field.h"

namespace prairie {

/// What the person at the keys wants, each direction −1…1.
struct Steering {
  double forward = 0.0;
  double right = 0.0;
  double up = 0.0;  // ignored while walking
  bool fast = false;
  double turn_right_px = 0.0;  // mouse movement since the last step
  double turn_up_px = 0.0;
  double wheel =
      0.0;  // notches since the last step, away from the person positive; nothing to who flies or walks
};

class FlyCamera {
 public:
  /// Walks if the camera stands no higher above the ground than a person could, otherwise flies.
  FlyCamera(const Camera& start, const HeightField& ground);

  const Camera& camera() const { return camera_; }
  bool walks() const { return walks_; }

  /// The size of the picture, after the window's.
  void resize(glm::ivec2 size_px) { camera_.size_px = size_px; }

  /// Switches between flying and walking; who lands stands on the ground below.
  void toggle_walking(const HeightField& ground);

  /// Moves and turns for `dt_s` seconds. Flying goes where the camera looks; walking follows the ground.
  void move(const Steering& steering, double dt_s, const HeightField& ground);

 private:
  void turn(const Steering& steering);
  void settle(const HeightField& ground);

  Camera camera_;
  bool walks_ = false;
  double eye_height_m_ = 0.0;  // above the ground while walking
};

}  // namespace prairie
