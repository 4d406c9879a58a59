// The wind that all else adds to: constant, or replayed from a measured series.
//
// Velocities blow towards their heading: radians from east, counter-clockwise. Between the samples of a
// series velocity is linear in time; before the first and after the last it is constant. The series is that
// of one place; elsewhere it comes earlier or later by the way that the series' mean wind takes (Taylor's
// frozen turbulence), so that gusts travel.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace prairie {

/// A measured wind, one entry of each per sample.
struct WindSeries {
  std::vector<double> times_s;         // rising
  std::vector<double> speeds_m_per_s;  // 0…100
  std::vector<double> headings_rad;
  glm::dvec2 place_m{0.0};  // where it was measured
};

class MeanWind {
 public:
  /// Calm.
  MeanWind() : MeanWind(glm::dvec2(0.0)) {}
  /// Throws BadInput where the speed is not in 0…100 m/s.
  explicit MeanWind(glm::dvec2 velocity_m_per_s);
  /// Throws BadInput that names the sample and what was expected.
  explicit MeanWind(const WindSeries& series);

  /// Where its series was measured.
  glm::dvec2 place_m() const { return place_m_; }

  glm::dvec2 velocity_m_per_s(glm::dvec2 position_m, double time_s) const;

  /// Takes the place of another wind at a time: what drifts with it goes on from where that has brought it.
  void follow(const MeanWind& before, double time_s);

  /// How far the wind of the series' place has blown since time 0: ∫ velocity dt; or what it followed and
  /// then it.
  glm::dvec2 drift_m(double time_s) const;

 private:
  glm::dvec2 series_velocity(double time_s) const;

  // At least one sample; drift_m_[n] is the integral from the first sample to the n-th.
  std::vector<double> times_s_;
  std::vector<glm::dvec2> velocities_;
  std::vector<glm::dvec2> drifts_m_;
  glm::dvec2 place_m_{0.0};
  glm::dvec2 delay_s_per_m_{0.0};
  glm::dvec2 followed_m_{0.0};
};

}  // namespace prairie
