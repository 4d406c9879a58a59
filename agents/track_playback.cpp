#include "agents/track_playback.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

namespace prairie {
namespace {

constexpr double kMostOfAStep = 1.5;
constexpr double kTurnS = 1.0;
constexpr glm::dvec2 kEast(1.0, 0.0);

/// The direction of a vector, or `otherwise` where it has none.
glm::dvec2 direction(glm::dvec2 v, glm::dvec2 otherwise) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : otherwise;
}

/// `v` turned as (1, 0) is to the unit vector `by`.
glm::dvec2 turned(glm::dvec2 v, glm::dvec2 by) {
  return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

/// From one unit vector (`share` 0) to another (1) by the shorter way, left where both are as long. The
/// tangent of a quarter of the angle goes evenly, which for angles up to π is nearly an even turn and needs
/// no trigonometry.
glm::dvec2 between(glm::dvec2 from, glm::dvec2 to, double share) {
  const double cosine = glm::dot(from, to), sine = from.x * to.y - from.y * to.x;
  const glm::dvec2 half = cosine > -1.0 ? direction({1.0 + cosine, sine}, {0.0, 1.0}) : glm::dvec2(0.0, 1.0);
  const double tangent = share * half.y / (1.0 + half.x);
  const glm::dvec2 part = glm::dvec2(1.0 - tangent * tangent, 2.0 * tangent) / (1.0 + tangent * tangent);
  return glm::normalize(turned(turned(from, part), part));
}

double smooth(double x) {
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

TrackPlayback::TrackPlayback(Track track) : track_(std::move(track)) {
  assert(!track_.times_s.empty() && track_.times_s.size() == track_.positions_m.size());
  assert(std::adjacent_find(track_.times_s.begin(), track_.times_s.end(), std::greater_equal<>()) ==
         track_.times_s.end());
  const std::size_t count = track_.times_s.size();
  tangents_m_per_s_.assign(count, glm::dvec2(0.0));
  if (count < 2) return;
  tangents_m_per_s_.front() = step_velocity(0);
  tangents_m_per_s_.back() = step_velocity(count - 2);
  for (std::size_t n = 1; n + 1 < count; ++n) {
    const double before_s = step_s(n - 1), after_s = step_s(n);
    const glm::dvec2 before = step_velocity(n - 1), after = step_velocity(n);
    const glm::dvec2 tangent = (after_s * before + before_s * after) / (before_s + after_s);
    const double length = glm::length(tangent);
    const double most = kMostOfAStep * std::min(glm::length(before), glm::length(after));
    tangents_m_per_s_[n] = length > most ? tangent * (most / length) : tangent;
  }
  find_spells();
}

glm::dvec2 TrackPlayback::step_velocity(std::size_t step) const {
  return (track_.positions_m[step + 1] - track_.positions_m[step]) / step_s(step);
}

// The derivative of the Hermite curve: with v the velocity of the step, a and b the tangents at its ends,
// a + (6v − 4a − 2b) u + (3a + 3b − 6v) u².
PieceVelocity TrackPlayback::piece_velocity(std::size_t step) const {
  const glm::dvec2 v = step_velocity(step), a = tangents_m_per_s_[step], b = tangents_m_per_s_[step + 1];
  return {a, 6.0 * v - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * v};
}

void TrackPlayback::find_spells() {
  const glm::dvec2 whole = direction(track_.positions_m.back() - track_.positions_m.front(), kEast);
  for (std::size_t step = 0; step + 1 < track_.times_s.size(); ++step) {
    const PieceVelocity velocity = piece_velocity(step);
    for (const SlowSpell& spell : slow_spells(velocity, kStandingSpeedMPerS)) {
      const double start_s = track_.times_s[step], length_s = step_s(step);
      const double from_s = start_s + spell.from * length_s;
      const double to_s = spell.to < 1.0 ? start_s + spell.to * length_s : track_.times_s[step + 1];
      const glm::dvec2 before = direction(velocity.at(spell.from), whole),
                       after = direction(velocity.at(spell.to), whole);
      if (!spells_.empty() && spells_.back().to_s == from_s) {
        spells_.back().to_s = to_s;
        spells_.back().after = after;
      } else {
        spells_.push_back({from_s, to_s, before, after});
      }
    }
  }
  if (spells_.empty()) return;
  StandingSpell &first = spells_.front(), &last = spells_.back();
  const bool from_start = first.from_s == first_s(), to_end = last.to_s == last_s();
  if (spells_.size() == 1 && from_start && to_end)
    first.before = first.after = whole;
  else if (from_start)
    first.before = first.after;
  if (to_end && (spells_.size() > 1 || !from_start)) last.after = last.before;
}

glm::dvec2 TrackPlayback::forward(double time_s, glm::dvec2 velocity_m_per_s) const {
  const auto next = std::upper_bound(spells_.begin(), spells_.end(), time_s,
                                     [](double t, const StandingSpell& spell) { return t < spell.from_s; });
  if (next == spells_.begin() || time_s > std::prev(next)->to_s) return direction(velocity_m_per_s, kEast);
  const StandingSpell& spell = *std::prev(next);
  const double turn_s = std::min(kTurnS, spell.to_s - spell.from_s);
  const double share = turn_s > 0.0 ? std::clamp(1.0 - (spell.to_s - time_s) / turn_s, 0.0, 1.0) : 1.0;
  return between(spell.before, spell.after, smooth(share));
}

TrackPlace TrackPlayback::at(double time_s) const {
  assert(std::isfinite(time_s));
  TrackPlace place;
  place.present = time_s >= first_s() && time_s <= last_s();
  const double within_s = std::clamp(time_s, first_s(), last_s());
  if (track_.times_s.size() == 1) {
    place.position_m = track_.positions_m.front();
    return place;
  }
  const auto after = std::upper_bound(track_.times_s.begin() + 1, track_.times_s.end() - 1, within_s);
  const auto step = static_cast<std::size_t>(after - track_.times_s.begin()) - 1;
  const double u = (within_s - track_.times_s[step]) / step_s(step), rest = 1.0 - u;
  // The Hermite curve, written so that it is exact at both ends.
  place.position_m =
      (1.0 + 2.0 * u) * rest * rest * track_.positions_m[step] +
      u * u * (1.0 + 2.0 * rest) * track_.positions_m[step + 1] +
      step_s(step) * u * rest * (rest * tangents_m_per_s_[step] - u * tangents_m_per_s_[step + 1]);
  const glm::dvec2 velocity_m_per_s = piece_velocity(step).at(u);
  place.forward = forward(within_s, velocity_m_per_s);
  if (place.present) {
    place.velocity_m_per_s = velocity_m_per_s;
    place.speed_m_per_s = glm::length(velocity_m_per_s);
  }
  return place;
}

}  // namespace prairie
