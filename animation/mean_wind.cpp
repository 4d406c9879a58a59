#include "animation/mean_wind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "animation/heading.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kMostSpeed = 100.0;

// A series in slower wind than this blows everywhere at once.
constexpr double kLeastTravelSpeed = 0.5;

void check(bool good, std::size_t sample, const char* field, double found, const char* expected) {
  if (!good)
    throw BadInput("", fmt::format("wind series: sample {}: {}", sample, field), fmt::format("{}", found),
                   expected);
}

}  // namespace

MeanWind::MeanWind(glm::dvec2 velocity_m_per_s)
    : times_s_{0.0}, velocities_{velocity_m_per_s}, drifts_m_{glm::dvec2(0.0)} {
  const double speed = glm::length(velocity_m_per_s);
  if (!(speed <= kMostSpeed))
    throw BadInput("", "wind: speed_m_per_s", fmt::format("{}", speed), "0 to 100 m/s");
}

MeanWind::MeanWind(const WindSeries& series) : times_s_(series.times_s), place_m_(series.place_m) {
  const std::size_t samples = times_s_.size();
  if (samples == 0 || series.speeds_m_per_s.size() != samples || series.headings_rad.size() != samples) {
    throw BadInput("", "wind series",
                   fmt::format("{} times, {} speeds, {} headings", samples, series.speeds_m_per_s.size(),
                               series.headings_rad.size()),
                   "as many of each, at least one");
  }
  if (!std::isfinite(place_m_.x) || !std::isfinite(place_m_.y)) {
    throw BadInput("", "wind series: place_m", "a number that is not finite", "metres");
  }
  for (std::size_t n = 0; n < samples; ++n) {
    const double time_s = times_s_[n], speed = series.speeds_m_per_s[n], heading_rad = series.headings_rad[n];
    check(std::isfinite(time_s) && (n == 0 || time_s > times_s_[n - 1]), n, "time_s", time_s,
          "seconds that rise from sample to sample");
    check(speed >= 0.0 && speed <= kMostSpeed, n, "speed_m_per_s", speed, "0 to 100 m/s");
    check(std::abs(heading_rad) <= 1e3, n, "heading_rad", heading_rad, "radians");
    velocities_.push_back(speed * direction_of(heading_rad));
    drifts_m_.push_back(n == 0 ? glm::dvec2(0.0)
                               : drifts_m_[n - 1] + 0.5 * (time_s - times_s_[n - 1]) *
                                                        (velocities_[n - 1] + velocities_[n]));
  }
  if (samples < 2) return;
  const glm::dvec2 mean = drifts_m_.back() / (times_s_.back() - times_s_.front());
  const double speed = glm::length(mean);
  if (speed > kLeastTravelSpeed) delay_s_per_m_ = mean / (speed * speed);
}

glm::dvec2 MeanWind::series_velocity(double time_s) const {
  if (time_s <= times_s_.front()) return velocities_.front();
  if (time_s >= times_s_.back()) return velocities_.back();
  const auto next =
      static_cast<std::size_t>(std::upper_bound(times_s_.begin(), times_s_.end(), time_s) - times_s_.begin());
  const double share = (time_s - times_s_[next - 1]) / (times_s_[next] - times_s_[next - 1]);
  return velocities_[next - 1] + share * (velocities_[next] - velocities_[next - 1]);
}

glm::dvec2 MeanWind::velocity_m_per_s(glm::dvec2 position_m, double time_s) const {
  if (velocities_.size() == 1) return velocities_.front();
  return series_velocity(time_s - glm::dot(position_m - place_m_, delay_s_per_m_));
}

glm::dvec2 MeanWind::drift_m(double time_s) const {
  const auto from_first = [&](double until_s) {
    if (until_s <= times_s_.front()) return (until_s - times_s_.front()) * velocities_.front();
    if (until_s >= times_s_.back())
      return drifts_m_.back() + (until_s - times_s_.back()) * velocities_.back();
    const auto next = static_cast<std::size_t>(std::upper_bound(times_s_.begin(), times_s_.end(), until_s) -
                                               times_s_.begin());
    const double passed_s = until_s - times_s_[next - 1];
    return drifts_m_[next - 1] + 0.5 * passed_s * (velocities_[next - 1] + series_velocity(until_s));
  };
  return followed_m_ + from_first(time_s) - from_first(0.0);
}

void MeanWind::follow(const MeanWind& before, double time_s) {
  followed_m_ += before.drift_m(time_s) - drift_m(time_s);
}

}  // namespace prairie
