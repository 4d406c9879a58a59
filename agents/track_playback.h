// Where a recorded walker is at a time, and which way it faces: a function of track and time alone.
//
// Between its points a track is a cubic Hermite curve in time, so that it passes exactly through the data at
// its time stamps, with a velocity without jumps. The tangents are those of the parabola through a point and
// its neighbours (Catmull–Rom for uneven times), no longer than 1.5 times the slower of the two steps beside
// it: who stands between two stamps stays there, and the curve leaves the chord of a step by at most 4/27 ·
// (1.5 + 1.5) = 0.44 of its length, sideways or beyond its end. In a step slower than kStandingSpeedMPerS
// that is below 4 cm at the 0.4 s of crowd recordings. (Tangents that are monotone per axis would not
// overshoot at all, but would depend on how the axes lie: a recording that is placed turned would be walked
// otherwise.) At the ends the tangent is the step itself.
//
// The heading is the direction of the velocity. Where the speed falls below kStandingSpeedMPerS it holds, and
// turns within the last second of such a spell, the shorter way round, to the direction in which the walker
// sets off; so it never jumps. A spell at the start or end takes the one direction that it borders on; a
// track that is slow throughout faces from its first point to its last, or east where they are one.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "agents/slow_spells.h"
#include "agents/track.h"

namespace prairie {

inline constexpr double kStandingSpeedMPerS = 0.2;

struct TrackPlace {
  bool present = false;  // between the first and the last time, both included
  glm::dvec2 position_m{0.0};
  glm::dvec2 velocity_m_per_s{0.0};
  double speed_m_per_s = 0.0;
  glm::dvec2 forward{1.0, 0.0};  // unit
};

/// One track, made ready for at().
class TrackPlayback {
 public:
  explicit TrackPlayback(Track track);

  const Track& track() const { return track_; }
  double first_s() const { return track_.times_s.front(); }
  double last_s() const { return track_.times_s.back(); }

  /// O(log n). Before its time a walker stands at the first point, after it at the last, and is not
  /// `present`.
  TrackPlace at(double time_s) const;

 private:
  struct StandingSpell {
    double from_s, to_s;
    glm::dvec2 before, after;  // unit: which way it faces when it starts and ends
  };

  double step_s(std::size_t step) const { return track_.times_s[step + 1] - track_.times_s[step]; }
  glm::dvec2 step_velocity(std::size_t step) const;
  PieceVelocity piece_velocity(std::size_t step) const;
  void find_spells();
  glm::dvec2 forward(double time_s, glm::dvec2 velocity_m_per_s) const;

  Track track_;
  std::vector<glm::dvec2> tangents_m_per_s_;  // one per point
  std::vector<StandingSpell> spells_;         // in order, disjoint
};

}  // namespace prairie
