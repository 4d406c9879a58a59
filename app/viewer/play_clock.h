// How much of the time that passes at a window passes in its world: even steps, none while it is paused.
#pragma once

namespace prairie {

struct EvenSteps {
  int count = 0;
  double dt_s = 0.0;
};

class PlayClock {
 public:
  static constexpr double kLongestStepS = 1.0 / 30.0;
  /// Of a frame: after a slow one the world has fallen behind rather than take ever longer to catch up.
  static constexpr double kMostPerFrameS = 0.1;

  explicit PlayClock(bool paused) : paused_(paused) {}

  bool paused() const { return paused_; }
  void toggle_pause() { paused_ = !paused_; }
  /// One longest step in the next frame, though time pauses.
  void step_once();

  /// The steps of a frame since whose predecessor so much time has passed.
  EvenSteps take(double passed_s);

 private:
  bool paused_;
  int single_steps_ = 0;
};

}  // namespace prairie
