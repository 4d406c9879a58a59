#include "agents/footing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "agents/plane_vectors.h"
#include "agents/skeleton.h"
#include "animation/range_check.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kFastest = 20.0;  // m/s
constexpr double kFarthestM = 1e6;
constexpr double kSteadying = 3.0;     // m/s², of the speed that the gait follows
constexpr double kStandsBelow = 0.05;  // m/s
constexpr double kStandingHalfWidthM = 0.085;
constexpr double kRestlessM = 0.10;       // a standing walker's foot, from where it should be
constexpr double kRestlessCosine = 0.87;  // and turned away by 30 degrees
constexpr double kTurnPeriod = 0.8;       // of steps on the spot, as a share of the recorded stride's
constexpr double kLatestLift = 0.6;       // of a swing: later a foot waits for its next
constexpr double kStretchedM = 0.66;      // farther from its place a foot that stands hurries the gait
constexpr double kMostHurry = 4.0;
constexpr double kShorterOnSlopes = 1.0;  // per unit of grade, the stride's share

double fraction(double x) {
  return x - std::floor(x);
}

double side_of(std::size_t foot) {
  return foot == 0 ? 1.0 : -1.0;
}

double own_phase(double phase, std::size_t foot) {
  return foot == 0 ? phase : fraction(phase + 0.5);
}

/// Of the way of a swing after a share of its time; it starts and ends at rest.
double eased(double share) {
  return share * share * (3.0 - 2.0 * share);
}

glm::dvec2 steady_unit(glm::dvec2 v, glm::dvec2 otherwise) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y);
  return length > 1e-6 ? v / length : otherwise;
}

/// Of the track, which is narrower the faster the walk.
double half_width_m(const Footing& footing, const Gait& gait) {
  const double walking = std::min(footing.speed_m_per_s / gait.speed_m_per_s, 1.0);
  return footing.scale * (kStandingHalfWidthM + walking * (gait.half_width * kLegM - kStandingHalfWidthM));
}

/// Below the body.
glm::dvec2 home_m(const Footing& footing, const Gait& gait, const BodyStep& body, std::size_t foot) {
  return body.position_m + side_of(foot) * half_width_m(footing, gait) * left_of(body.forward);
}

bool is_restless(const Footing& footing, const Gait& gait, const BodyStep& body, std::size_t foot) {
  const Foot& of = footing.feet[foot];
  return glm::distance(of.position_m, home_m(footing, gait, body, foot)) > kRestlessM * footing.scale ||
         glm::dot(of.forward, body.forward) < kRestlessCosine;
}

/// By how much the gait is hastened for the sake of a foot that is left behind or twisted.
double hurry_of(const Footing& footing, const Gait& gait, const BodyStep& body) {
  double hurry = 1.0;
  for (std::size_t n = 0; n < 2; ++n) {
    const Foot& foot = footing.feet[n];
    if (!foot.planted) continue;
    const double stretch =
        glm::distance(foot.position_m, home_m(footing, gait, body, n)) / (kStretchedM * footing.scale);
    const double twist = 1.5 - glm::dot(foot.forward, body.forward);  // over 1 from 60 degrees on
    hurry = std::max(hurry, 1.0 + 6.0 * (std::max(stretch, twist) - 1.0));
  }
  return std::min(hurry, kMostHurry);
}

}  // namespace

void check(const Footing& footing) {
  check_range("scale", footing.scale, 0.3, 3.0);
  check_range("phase", footing.phase, 0.0, 1.0);
  check_range("speed_m_per_s", footing.speed_m_per_s, 0.0, kFastest);
  for (const Foot& foot : footing.feet) {
    check_range("position_m", foot.position_m.x, -kFarthestM, kFarthestM);
    check_range("position_m", foot.position_m.y, -kFarthestM, kFarthestM);
    check_range("forward", glm::length(foot.forward), 0.999, 1.001);
    check_range("share", foot.share, 0.0, 1.0);
    check_range("lift_phase", foot.lift_phase, 0.0, 0.999);
  }
  if (!footing.feet[0].planted && !footing.feet[1].planted)
    throw BadInput("", "planted", "both feet in the air", "one at most");
}

Footing standing(glm::dvec2 position_m, glm::dvec2 forward, double scale) {
  assert(scale >= 0.3 && scale <= 3.0);
  Footing footing;
  footing.scale = scale;
  footing.phase = 0.5;  // the left foot lifts first
  for (std::size_t n = 0; n < 2; ++n) {
    footing.feet[n].position_m = position_m + side_of(n) * kStandingHalfWidthM * scale * left_of(forward);
    footing.feet[n].forward = forward;
    footing.feet[n].share = n == 0 ? 0.8 : 0.0;
  }
  return footing;
}

void advance(Footing& footing, const Gait& gait, const BodyStep& body, double dt_s) {
  assert(dt_s >= 0.0 && dt_s <= 0.1 && body.speed_m_per_s >= 0.0);
  for (const Foot& foot : footing.feet) {
    if (glm::distance(foot.position_m, body.position_m) > 2.0 * kLegM * footing.scale) {
      footing = standing(body.position_m, body.forward, footing.scale);
      return;
    }
  }
  const double change = body.speed_m_per_s - footing.speed_m_per_s;
  footing.speed_m_per_s += std::clamp(change, -kSteadying * dt_s, kSteadying * dt_s);

  const bool walks = body.speed_m_per_s > kStandsBelow;
  const bool both_stand = footing.feet[0].planted && footing.feet[1].planted;
  std::array<bool, 2> may_lift = {walks, walks};
  if (!walks) {
    for (std::size_t n = 0; n < 2; ++n) may_lift[n] = is_restless(footing, gait, body, n);
    if (both_stand && !may_lift[0] && !may_lift[1]) return;
  }

  double period_s = kTurnPeriod * gait.period_s * std::sqrt(footing.scale);
  if (walks) {
    period_s = stride_period_s(gait, body.speed_m_per_s, footing.scale) /
               (1.0 + kShorterOnSlopes * std::abs(body.grade));
  }
  period_s /= hurry_of(footing, gait, body);
  footing.phase = fraction(footing.phase + dt_s / period_s);
  const double stance = stance_share(gait, body.speed_m_per_s, footing.scale);

  for (std::size_t n = 0; n < 2; ++n) {
    Foot& foot = footing.feet[n];
    const double phase = own_phase(footing.phase, n);
    if (foot.planted) {
      const bool in_swing = phase >= stance && phase < stance + kLatestLift * (1.0 - stance);
      if (in_swing && may_lift[n] && footing.feet[1 - n].planted) {
        foot = {foot.position_m, foot.forward, false, 0.0, phase};
      } else {
        foot.share = std::min(phase / stance, 1.0);
      }
      continue;
    }
    const bool strikes = phase < foot.lift_phase;
    const double share = strikes ? 1.0 : (phase - foot.lift_phase) / (1.0 - foot.lift_phase);
    const double left_s = strikes ? 0.0 : (1.0 - phase) * period_s;
    const double ahead_m = body.speed_m_per_s * (left_s + gait.lead * stance * period_s);
    const glm::dvec2 target_m = home_m(footing, gait, body, n) + ahead_m * body.forward;
    const double done = eased(foot.share);
    const double part = strikes ? 1.0 : (eased(share) - done) / std::max(1.0 - done, 1e-9);
    foot.position_m += part * (target_m - foot.position_m);
    foot.forward = steady_unit(foot.forward + part * (body.forward - foot.forward), body.forward);
    foot.planted = strikes;
    foot.share = strikes ? std::min(phase / stance, 1.0) : share;
  }
}

double key_phase(const Gait& gait, const Foot& foot) {
  return foot.planted ? foot.share * gait.stance : gait.stance + foot.share * (1.0 - gait.stance);
}

}  // namespace prairie
