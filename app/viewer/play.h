// The world at a window, which moves, and what a person does in it: pauses time, sets the wind, sends gusts
// and tornadoes, lets stones roll and drives a cart. Knows neither windows, keys nor OpenGL.
#pragma once

#include <cstddef>
#include <optional>

#include "agents/driven_cart.h"
#include "agents/driven_mover.h"
#include "agents/rolling_stone.h"
#include "app/viewer/play_clock.h"
#include "app/viewer/wind_controls.h"
#include "lod/camera.h"

namespace prairie {

class World;

class Play {
 public:
  /// Also has the camera stir the air.
  Play(World& world, bool paused);

  /// The world is seen by this camera.
  void look(const Camera& camera);
  /// The same, and lets it go on for a frame.
  void advance(double passed_s, const CartControls& controls, const Camera& camera);

  void toggle_pause() { clock_.toggle_pause(); }
  void step_once() { clock_.step_once(); }
  void send_gust(const Camera& camera);
  void send_tornado(const Camera& camera);
  void roll_stone(const Camera& camera);
  /// A cart stands ahead, in place of one that was taken before.
  void take_cart(const Camera& camera);
  void leave_cart();
  void set_wind(const WindControls& wind);

  bool paused() const { return clock_.paused(); }
  bool has_cart() const { return cart_.has_value(); }
  const WindControls& wind() const { return wind_; }
  /// What the steps of the last frame that had any took, milliseconds.
  double steps_ms() const { return steps_ms_; }

 private:
  void put_down(DrivenMover mover);
  void move_driven(const CartControls& controls, double dt_s);

  World& world_;
  PlayClock clock_;
  WindControls wind_;
  std::optional<RollingStone> stone_;
  std::optional<DrivenCart> cart_;
  double steps_ms_ = 0.0;
};

}  // namespace prairie
