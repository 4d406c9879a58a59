// Bodies that wander about, for tests of treading: a pure function of (body, step).
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "animation/treading.h"

namespace prairie {

/// Walkers at about 1.2 m/s on ways that cross; every seventh stands now and then, every eleventh is a heavy
/// stone.
class RandomWalkers {
 public:
  RandomWalkers(std::uint32_t count, double square_m, double dt_s)
      : count_(count), square_m_(square_m), dt_s_(dt_s) {}

  std::vector<TreadStep> steps(int step) const {
    std::vector<TreadStep> steps;
    for (std::uint32_t id = 0; id < count_; ++id) {
      TreadStep one;
      one.id = id;
      one.from_m = place(id, step);
      one.to_m = place(id, step + 1);
      one.radius_m = id % 11 == 3 ? 0.3 : 0.1;
      one.weight = id % 11 == 3 ? 4.0 : 1.0;
      if (id % 7 == 2 && (step / 30) % 2 == 1) one.from_m = one.to_m = place(id, step / 30 * 30);
      steps.push_back(one);
    }
    return steps;
  }

 private:
  glm::dvec2 place(std::uint32_t id, int step) const {
    const double t_s = step * dt_s_;
    const double phase = 2.399963229728653 * id;
    const double radius_m = 2.0 + 0.37 * (id % 13);
    const double angle = phase + 1.2 * t_s / radius_m;
    const double column = std::fmod(0.7548776662466927 * (id + 1), 1.0);
    const double row = std::fmod(0.5698402909980532 * (id + 1), 1.0);
    return square_m_ * glm::dvec2(column - 0.5, row - 0.5) +
           radius_m * glm::dvec2(std::cos(angle), std::sin(angle));
  }

  std::uint32_t count_;
  double square_m_, dt_s_;
};

}  // namespace prairie
