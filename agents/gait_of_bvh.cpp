#include "agents/gait_of_bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "agents/body_joints.h"
#include "agents/measured_walk.h"
#include "agents/skeleton.h"
#include "agents/sole.h"

namespace prairie {
namespace {

using Curve = std::vector<double>;

/// Where a curve is highest in reach of ±reach frames, between frames by the parabola through three; not at
/// the ends, where it may still be rising.
Curve peaks(const Curve& values, std::size_t reach) {
  Curve found;
  for (std::size_t n = 1; n + 1 < values.size(); ++n) {
    const std::size_t first = n > reach ? n - reach : 0, last = std::min(n + reach, values.size() - 1);
    const auto highest = std::max_element(values.begin() + static_cast<std::ptrdiff_t>(first),
                                          values.begin() + static_cast<std::ptrdiff_t>(last + 1));
    if (highest != values.begin() + static_cast<std::ptrdiff_t>(n)) continue;
    const double before = values[n - 1], at = values[n], after = values[n + 1];
    const double bend = before - 2.0 * at + after;
    found.push_back(static_cast<double>(n) + (bend < 0.0 ? 0.5 * (before - after) / bend : 0.0));
  }
  return found;
}

struct Events {
  Curve strikes, toe_offs;  // in frames
};

/// The toes are farthest behind only once they are as fast as the hips. From that frame back to where they
/// left their place.
double left_place(const Walk& walk, std::size_t side, double farthest_behind) {
  const auto last = static_cast<std::size_t>(farthest_behind);
  const auto earlier = static_cast<std::size_t>(std::min(0.25 / walk.frame_s, farthest_behind));
  const auto toes_m = [&](std::size_t n) { return walk.frames[n].places_m[side][kToes].x; };
  const double stood_m = toes_m(last - earlier);
  std::size_t n = last;
  while (n > last - earlier && toes_m(n) - stood_m > 0.03 * walk.leg_m) --n;
  return static_cast<double>(n);
}

Events events_of(const Walk& walk, std::size_t side) {
  Curve ahead, behind;
  for (const WalkFrame& frame : walk.frames) {
    ahead.push_back(frame.places_m[side][kAnkle].x - frame.hips_m().x);
    behind.push_back(frame.hips_m().x - frame.places_m[side][kToes].x);
  }
  constexpr double kReachS = 0.35;
  const auto reach = static_cast<std::size_t>(std::max(kReachS / walk.frame_s, 1.0));
  Events events{peaks(ahead, reach), peaks(behind, reach)};
  std::erase_if(events.strikes,
                [&](double n) { return ahead[static_cast<std::size_t>(n)] < 0.1 * walk.leg_m; });
  std::erase_if(events.toe_offs,
                [&](double n) { return behind[static_cast<std::size_t>(n)] < 0.1 * walk.leg_m; });
  for (double& toe_off : events.toe_offs) toe_off = left_place(walk, side, toe_off);
  return events;
}

/// The values of a key frame (agents/gait.h) in one frame; `side` is the one taken for the left.
std::array<double, kGaitCurveCount> key_values(const Walk& walk, const WalkFrame& frame, std::size_t side) {
  const double mirror = side == 0 ? 1.0 : -1.0;
  const auto& near = frame.places_m[side];
  const auto& far = frame.places_m[1 - side];
  const auto mirrored = [mirror](glm::dvec3 v) { return glm::dvec3(v.x, mirror * v.y, v.z); };
  const auto yaw_of = [](glm::dvec3 leftward) { return std::atan2(-leftward.x, leftward.y); };
  const glm::dvec3 hips = mirrored(near[kHip] - far[kHip]),
                   shoulders = mirrored(near[kShoulder] - far[kShoulder]);
  const glm::dvec3 trunk = frame.neck_m - frame.hips_m();
  const glm::dvec3 upper = mirrored(near[kElbow] - near[kShoulder]),
                   lower = mirrored(near[kWrist] - near[kElbow]);
  const glm::dvec3 foot = near[kToes] - near[kAnkle];
  const double pitch = pitch_of(foot) - walk.flat_rad[side];
  const double bend = glm::dot(upper, lower) / std::max(glm::length(upper) * glm::length(lower), 1e-9);
  const double rolled = (rolled_ankle(pitch).y - kAnkleHeightM) / kLegM;
  std::array<double, kGaitCurveCount> values{};
  const auto set = [&values](GaitCurve curve, double value) {
    values[static_cast<std::size_t>(curve)] = value;
  };
  set(GaitCurve::kPelvisRise, (frame.hips_m().z - walk.ankle_m) / walk.leg_m);
  set(GaitCurve::kPelvisSway, mirror * frame.hips_m().y / walk.leg_m);
  set(GaitCurve::kPelvisYaw, yaw_of(hips));
  set(GaitCurve::kPelvisList, pitch_of(hips));
  set(GaitCurve::kChestYaw, yaw_of(shoulders));
  set(GaitCurve::kChestList, pitch_of(shoulders));
  set(GaitCurve::kChestPitch, std::atan2(trunk.x, trunk.z));
  set(GaitCurve::kArmSwing, std::atan2(upper.x, -upper.z));
  set(GaitCurve::kArmSpread, std::atan2(upper.y, std::hypot(upper.x, upper.z)));
  set(GaitCurve::kElbow, std::acos(std::clamp(bend, -1.0, 1.0)));
  set(GaitCurve::kSolePitch, pitch);
  set(GaitCurve::kSoleLift, (near[kAnkle].z - walk.ankle_m) / walk.leg_m - rolled);
  return values;
}

/// Of two frames' values, for a place between them.
std::array<double, kGaitCurveCount> values_at(const Walk& walk, std::size_t side, double place) {
  const std::size_t first = std::min(static_cast<std::size_t>(place), walk.frames.size() - 2);
  const double t = place - static_cast<double>(first);
  auto values = key_values(walk, walk.frames[first], side);
  const auto after = key_values(walk, walk.frames[first + 1], side);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] += t * (after[n] - values[n]);
  return values;
}

/// What belongs to both sides is the same half a cycle later, or the opposite. The trunk's lean and the
/// soles' clearance are known but for a constant, which depends on where the file's joints lie in the body.
void make_symmetric(Gait& gait) {
  constexpr std::size_t kHalf = kGaitKeyCount / 2;
  const auto keys_of = [&gait](GaitCurve curve) -> auto& {
    return gait.keys[static_cast<std::size_t>(curve)];
  };
  const auto fold = [&](GaitCurve curve, double sign) {
    auto& keys = keys_of(curve);
    for (std::size_t n = 0; n < kHalf; ++n) {
      keys[n] = 0.5 * (keys[n] + sign * keys[n + kHalf]);
      keys[n + kHalf] = sign * keys[n];
    }
  };
  for (const GaitCurve curve : {GaitCurve::kPelvisRise, GaitCurve::kChestPitch}) fold(curve, 1.0);
  for (const GaitCurve curve : {GaitCurve::kPelvisSway, GaitCurve::kPelvisYaw, GaitCurve::kPelvisList,
                                GaitCurve::kChestYaw, GaitCurve::kChestList}) {
    fold(curve, -1.0);
  }
  auto& pitch = keys_of(GaitCurve::kChestPitch);
  const double mean = std::accumulate(pitch.begin(), pitch.end(), 0.0) / static_cast<double>(kGaitKeyCount);
  for (double& key : pitch) key -= mean;
  auto& lift = keys_of(GaitCurve::kSoleLift);
  const double floor =
      std::accumulate(lift.begin() + 2, lift.begin() + 7, 0.0) / 5.0;  // while the foot is flat
  for (double& key : lift) key = std::max(key - floor, 0.0);
}

}  // namespace

Gait gait_of(const BvhMotion& motion, std::optional<double> unit_m) {
  const BodyJoints joints = find_body_joints(motion);
  if (motion.frame_count() < 8) refuse_motion(motion, fmt::format("{} frames", motion.frame_count()));
  const Walk walk = measured_walk(motion, joints, unit_m);

  Gait gait;
  double cycles = 0.0, stances = 0.0;
  for (const std::size_t side : {0, 1}) {
    const Events events = events_of(walk, side);
    for (std::size_t n = 0; n + 1 < events.strikes.size(); ++n) {
      const double first = events.strikes[n], length = events.strikes[n + 1] - first;
      const double period_s = length * walk.frame_s;
      const auto frame_at = [&](double place) { return walk.frames[static_cast<std::size_t>(place)]; };
      const WalkFrame from = frame_at(first), to = frame_at(first + length);
      const double stride_m = to.hips_m().x - from.hips_m().x;
      cycles += 1.0;
      gait.period_s += period_s;
      gait.speed_m_per_s += stride_m / period_s;
      for (std::size_t key = 0; key < kGaitKeyCount; ++key) {
        const double phase = static_cast<double>(key) / static_cast<double>(kGaitKeyCount);
        auto values = values_at(walk, side, first + phase * length);
        // The way need not be quite straight: what is left over from cycle to cycle is no sway.
        const double mirror = side == 0 ? 1.0 : -1.0;
        const double drift_m = from.hips_m().y + phase * (to.hips_m().y - from.hips_m().y);
        values[static_cast<std::size_t>(GaitCurve::kPelvisSway)] -= mirror * drift_m / walk.leg_m;
        for (std::size_t curve = 0; curve < kGaitCurveCount; ++curve) gait.keys[curve][key] += values[curve];
      }
      for (const double toe_off : events.toe_offs) {
        if (toe_off <= first || toe_off >= first + length) continue;
        const double stance = (toe_off - first) / length;
        const WalkFrame flat = frame_at(first + 0.4 * stance * length);
        const glm::dvec3 ankle_m = flat.places_m[side][kAnkle];
        stances += 1.0;
        gait.stance += stance;
        gait.lead += (ankle_m.x - from.hips_m().x) / (stance * stride_m);
        const double middle_m = 0.5 * (from.hips_m().y + to.hips_m().y);
        gait.half_width += (side == 0 ? 1.0 : -1.0) * (ankle_m.y - middle_m) / walk.leg_m;
      }
    }
  }
  if (cycles == 0.0 || stances == 0.0)
    refuse_motion(motion, "no foot that strikes twice and leaves the ground between");
  gait.period_s /= cycles;
  gait.speed_m_per_s /= cycles;
  gait.stance /= stances;
  gait.lead /= stances;
  gait.half_width = std::clamp(gait.half_width / stances, 0.03, 0.2);
  for (auto& curve : gait.keys) {
    for (double& key : curve) key /= cycles;
  }
  make_symmetric(gait);

  if (!(gait.period_s > 0.4 && gait.period_s < 4.0 && gait.speed_m_per_s > 0.2 && gait.speed_m_per_s < 4.0))
    refuse_motion(motion,
                  fmt::format("{:.2f} m/s in strides of {:.2f} s", gait.speed_m_per_s, gait.period_s));
  if (!(gait.stance > 0.45 && gait.stance < 0.75 && gait.lead > 0.2 && gait.lead < 0.7))
    refuse_motion(motion, fmt::format("feet that stand {:.2f} of a stride", gait.stance));
  return gait;
}

}  // namespace prairie
