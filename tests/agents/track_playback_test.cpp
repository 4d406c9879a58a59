#include "agents/track_playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace prairie {
namespace {

/// Somebody who walks, turns, stands, trembles and turns back on the spot, seen at uneven times.
Track wandering(std::uint64_t seed, double step_s) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  Track track;
  double time_s = 10.0 * any(random), heading_rad = 6.0 * any(random), speed_m_per_s = 1.2;
  glm::dvec2 at_m(50.0 * any(random), 0.0);
  for (int n = 0; n < 60; ++n) {
    track.times_s.push_back(time_s);
    track.positions_m.push_back(at_m);
    if (n % 6 == 0) speed_m_per_s = any(random) < 0.4 ? 0.0 : 0.05 + 1.6 * any(random);
    if (n % 9 == 0 && any(random) < 0.5) heading_rad += 3.141592653589793;
    heading_rad += any(random) - 0.5;
    const double passed_s = step_s * (0.5 + any(random));
    const double tremble_m = n % 2 == 0 ? 0.002 * any(random) : 0.0;
    at_m += (speed_m_per_s * passed_s + tremble_m) * glm::dvec2(std::cos(heading_rad), std::sin(heading_rad));
    time_s += passed_s;
  }
  return track;
}

/// Walks east, stands from 3 s to 13 s, walks north.
Track halting() {
  Track track;
  for (int n = 0; n <= 3; ++n) {
    track.times_s.push_back(n);
    track.positions_m.emplace_back(1.25 * n, 0.0);
  }
  for (int n = 0; n <= 3; ++n) {
    track.times_s.push_back(13.0 + n);
    track.positions_m.emplace_back(3.75, 1.25 * n);
  }
  return track;
}

/// The largest angle in radians by which the heading jumps within any billionth of a second, up to what is
/// looked for.
bool jumps(const TrackPlayback& playback, double from_s, double to_s) {
  if (glm::distance(playback.at(from_s).forward, playback.at(to_s).forward) < 0.1) return false;
  if (to_s - from_s < 1e-9) return true;
  const double middle_s = 0.5 * (from_s + to_s);
  return jumps(playback, from_s, middle_s) || jumps(playback, middle_s, to_s);
}

TEST(TrackPlayback, PassesThroughTheData) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const TrackPlayback playback(wandering(seed, seed % 2 == 0 ? 0.4 : 9.0));
    const Track& track = playback.track();
    for (std::size_t n = 0; n < track.times_s.size(); ++n) {
      const TrackPlace place = playback.at(track.times_s[n]);
      EXPECT_TRUE(place.present);
      EXPECT_EQ(place.position_m, track.positions_m[n]);
    }
  }
}

TEST(TrackPlayback, VelocityIsTheDerivativeAndHasNoJumps) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TrackPlayback playback(wandering(seed, 0.4));
    constexpr double kStepS = 1e-5;
    for (double t = playback.first_s() + kStepS; t < playback.last_s() - kStepS; t += 0.0137) {
      const glm::dvec2 difference =
          (playback.at(t + kStepS).position_m - playback.at(t - kStepS).position_m) / (2.0 * kStepS);
      ASSERT_LT(glm::distance(playback.at(t).velocity_m_per_s, difference), 1e-3) << seed << ' ' << t;
      ASSERT_DOUBLE_EQ(playback.at(t).speed_m_per_s, glm::length(playback.at(t).velocity_m_per_s));
    }
    for (const double t : playback.track().times_s) {
      if (t == playback.first_s() || t == playback.last_s()) continue;
      EXPECT_LT(glm::distance(playback.at(t - 1e-9).velocity_m_per_s, playback.at(t + 1e-9).velocity_m_per_s),
                1e-6);
    }
  }
}

TEST(TrackPlayback, WalksStraightOnAtAnEvenSpeed) {
  Track track;
  for (const double t : {0.0, 0.4, 1.7, 2.0, 11.0}) {
    track.times_s.push_back(t);
    track.positions_m.emplace_back(5.0 + 0.8 * t, 3.0 - 0.6 * t);
  }
  const TrackPlayback playback(track);
  for (double t = 0.0; t <= 11.0; t += 0.1) {
    const TrackPlace place = playback.at(t);
    EXPECT_LT(glm::distance(place.position_m, glm::dvec2(5.0 + 0.8 * t, 3.0 - 0.6 * t)), 1e-12);
    EXPECT_NEAR(place.speed_m_per_s, 1.0, 1e-12);
    EXPECT_LT(glm::distance(place.forward, glm::dvec2(0.8, -0.6)), 1e-12);
  }
}

TEST(TrackPlayback, StaysCloseToTheChordOfEachStep) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const TrackPlayback playback(wandering(seed, 0.4));
    const Track& track = playback.track();
    for (std::size_t n = 0; n + 1 < track.times_s.size(); ++n) {
      const glm::dvec2 from_m = track.positions_m[n], step_m = track.positions_m[n + 1] - from_m;
      const double length_m = glm::length(step_m);
      for (double u = 0.0; u < 1.0; u += 0.05) {
        const double t = track.times_s[n] + u * (track.times_s[n + 1] - track.times_s[n]);
        const glm::dvec2 way_m = playback.at(t).position_m - from_m;
        const double along =
            length_m > 0.0 ? std::clamp(glm::dot(way_m, step_m) / (length_m * length_m), 0.0, 1.0) : 0.0;
        ASSERT_LE(glm::distance(way_m, along * step_m), 0.4445 * length_m + 1e-12) << seed << ' ' << t;
      }
    }
  }
}

TEST(TrackPlayback, StandsStillBetweenEqualPlaces) {
  const TrackPlayback playback(halting());
  for (double t = 3.0; t <= 13.0; t += 0.1) {
    EXPECT_LT(glm::distance(playback.at(t).position_m, glm::dvec2(3.75, 0.0)), 1e-12);
    EXPECT_EQ(playback.at(t).speed_m_per_s, 0.0);
  }
}

TEST(TrackPlayback, HeadingHoldsWhereTheWalkerStandsAndTurnsBeforeItSetsOff) {
  const TrackPlayback playback(halting());
  for (double t = 0.0; t < 12.0; t += 0.1)
    EXPECT_LT(glm::distance(playback.at(t).forward, glm::dvec2(1, 0)), 1e-9) << t;
  for (double t = 13.2; t < 16.0; t += 0.1)
    EXPECT_LT(glm::distance(playback.at(t).forward, glm::dvec2(0, 1)), 1e-9) << t;
  double turned = 0.0;
  for (double t = 12.0; t < 13.3; t += 0.01) {
    const glm::dvec2 forward = playback.at(t).forward;
    EXPECT_GE(forward.x, -1e-12);
    EXPECT_GE(forward.y, turned - 1e-12) << "it turns one way";
    turned = forward.y;
  }
}

TEST(TrackPlayback, HeadingFollowsTheWayIsAUnitVectorAndNeverJumps) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TrackPlayback playback(wandering(seed, seed % 3 == 0 ? 9.0 : 0.4));
    const double step_s = (playback.last_s() - playback.first_s()) / 3000.0;
    for (double t = playback.first_s() - 1.0; t < playback.last_s() + 1.0; t += step_s) {
      const TrackPlace place = playback.at(t);
      ASSERT_NEAR(glm::length(place.forward), 1.0, 1e-12) << seed << ' ' << t;
      if (place.speed_m_per_s > 1.001 * kStandingSpeedMPerS) {
        ASSERT_GT(glm::dot(place.forward, place.velocity_m_per_s), 0.999999 * place.speed_m_per_s)
            << seed << ' ' << t;
      }
      ASSERT_FALSE(jumps(playback, t, t + step_s)) << seed << ' ' << t;
    }
  }
}

TEST(TrackPlayback, TurnsBackOnTheSpotWithoutAJump) {
  Track track;
  for (const auto& [t, x] : {std::pair{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {3.0, 1.0}, {4.0, 0.0}}) {
    track.times_s.push_back(t);
    track.positions_m.emplace_back(x, 7.0);
  }
  const TrackPlayback playback(track);
  EXPECT_EQ(playback.at(0.5).forward, glm::dvec2(1.0, 0.0));
  EXPECT_EQ(playback.at(3.5).forward, glm::dvec2(-1.0, 0.0));
  for (double t = 0.0; t < 4.0; t += 0.01) EXPECT_FALSE(jumps(playback, t, t + 0.01)) << t;
}

TEST(TrackPlayback, IsThereFromItsFirstTimeToItsLast) {
  const TrackPlayback playback(halting());
  for (const double t : {-1e9, -0.001, 16.001, 1e9}) {
    const TrackPlace place = playback.at(t);
    EXPECT_FALSE(place.present);
    EXPECT_EQ(place.speed_m_per_s, 0.0);
    EXPECT_EQ(place.position_m, playback.track().positions_m[t < 0.0 ? 0 : 7]);
  }
  EXPECT_TRUE(playback.at(0.0).present);
  EXPECT_TRUE(playback.at(16.0).present);
}

TEST(TrackPlayback, OnePointIsThereForOneInstant) {
  const TrackPlayback playback({3, {5.0}, {{1.0, 2.0}}});
  EXPECT_FALSE(playback.at(4.999).present);
  EXPECT_TRUE(playback.at(5.0).present);
  EXPECT_EQ(playback.at(5.0).position_m, glm::dvec2(1.0, 2.0));
  EXPECT_EQ(playback.at(5.0).forward, glm::dvec2(1.0, 0.0));
}

TEST(TrackPlayback, WhoIsSlowThroughoutFacesHisEnd) {
  const TrackPlayback playback({3, {0.0, 100.0, 200.0}, {{0.0, 0.0}, {1.0, 1.0}, {0.0, 4.0}}});
  const TrackPlayback standing({3, {0.0, 100.0, 200.0}, {{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}});
  for (double t = 0.0; t <= 200.0; t += 1.0) {
    EXPECT_EQ(playback.at(t).forward, glm::dvec2(0.0, 1.0));
    EXPECT_EQ(standing.at(t).forward, glm::dvec2(1.0, 0.0));
  }
}

TEST(TrackPlayback, IsAFunctionOfTimeAlone) {
  const TrackPlayback one(wandering(1, 0.4)), other(wandering(1, 0.4));
  one.at(1e6);
  for (double t = one.last_s(); t > one.first_s(); t -= 0.173) {
    const TrackPlace a = one.at(t), b = other.at(t);
    EXPECT_EQ(a.position_m, b.position_m);
    EXPECT_EQ(a.forward, b.forward);
    EXPECT_EQ(a.velocity_m_per_s, b.velocity_m_per_s);
  }
}

TEST(Placed, MovesAndTurnsTheWholeWalk) {
  const Track track = wandering(7, 0.4);
  EXPECT_EQ(placed({track}, {0.0, 0.0}, 0.0)[0].positions_m, track.positions_m);
  constexpr double kTurnRad = 0.7;
  const glm::dvec2 origin_m(120.0, -40.0);
  const TrackPlayback before(track), after(placed({track}, origin_m, kTurnRad)[0]);
  const auto turned = [](glm::dvec2 v) {
    return glm::dvec2(std::cos(kTurnRad) * v.x - std::sin(kTurnRad) * v.y,
                      std::sin(kTurnRad) * v.x + std::cos(kTurnRad) * v.y);
  };
  for (double t = before.first_s(); t <= before.last_s(); t += 0.05) {
    const TrackPlace a = before.at(t), b = after.at(t);
    ASSERT_LT(glm::distance(b.position_m, origin_m + turned(a.position_m)), 1e-4) << t;
    ASSERT_LT(glm::distance(b.forward, turned(a.forward)), 1e-5) << t;
    ASSERT_NEAR(b.speed_m_per_s, a.speed_m_per_s, 1e-9) << t;
  }
}

}  // namespace
}  // namespace prairie
