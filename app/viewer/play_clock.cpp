#include "app/viewer/play_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prairie {

void PlayClock::step_once() {
  if (paused_) ++single_steps_;
}

EvenSteps PlayClock::take(double passed_s) {
  constexpr double kRounding = 1e-6;  // a thirtieth of a second plus a rounding error is one step
  if (const int single = std::exchange(single_steps_, 0); paused_) return {single, kLongestStepS};
  if (!(passed_s > 0.0)) return {};
  const double time_s = std::min(passed_s, kMostPerFrameS);
  const int count = std::max(static_cast<int>(std::ceil(time_s / kLongestStepS - kRounding)), 1);
  return {count, time_s / count};
}

}  // namespace prairie
