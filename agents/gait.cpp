#include "agents/gait.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace prairie {
namespace {

// Below this share of the recorded speed the cadence stays.
constexpr double kSlowest = 0.4;
// Of the share of a stride for which a foot stands, per metre a second (Murray et al. 1984: 0.66 slow, 0.60
// fast).
constexpr double kStanceSlope = -0.04;
constexpr double kMostAmplitude = 1.3;

/// Speeds of the same Froude number, for the figure's height.
double figure_speed(double speed_m_per_s, double scale) {
  assert(speed_m_per_s >= 0.0 && scale > 0.0);
  return speed_m_per_s / std::sqrt(scale);
}

}  // namespace

double at_phase(const Gait& gait, GaitCurve curve, double phase) {
  const auto& keys = gait.keys[static_cast<std::size_t>(curve)];
  const double place = (phase - std::floor(phase)) * static_cast<double>(kGaitKeyCount);
  const std::size_t first = std::min(static_cast<std::size_t>(place), kGaitKeyCount - 1);
  const double t = place - static_cast<double>(first), s = 1.0 - t;
  const auto key = [&](std::size_t steps) {
    return keys[(first + kGaitKeyCount - 1 + steps) % kGaitKeyCount];
  };
  const double p0 = key(1), p3 = key(2);
  const double p1 = p0 + (p3 - key(0)) / 6.0, p2 = p3 - (key(3) - p0) / 6.0;
  return s * s * (s * p0 + 3.0 * t * p1) + t * t * (3.0 * s * p2 + t * p3);
}

double stride_period_s(const Gait& gait, double speed_m_per_s, double scale) {
  const double speed = std::max(figure_speed(speed_m_per_s, scale), kSlowest * gait.speed_m_per_s);
  return gait.period_s * std::sqrt(scale * gait.speed_m_per_s / speed);
}

double stance_share(const Gait& gait, double speed_m_per_s, double scale) {
  const double faster = figure_speed(speed_m_per_s, scale) - gait.speed_m_per_s;
  return std::clamp(gait.stance + kStanceSlope * faster, 0.52, 0.75);
}

double gait_amplitude(const Gait& gait, double speed_m_per_s, double scale) {
  const double relative = figure_speed(speed_m_per_s, scale) / gait.speed_m_per_s;
  // As the stride's length: in proportion to the speed at a constant cadence, then with its root.
  const double slow_root = std::sqrt(kSlowest);
  const double amplitude = relative < kSlowest ? relative / slow_root : std::sqrt(relative);
  return std::min(amplitude, kMostAmplitude);
}

}  // namespace prairie
