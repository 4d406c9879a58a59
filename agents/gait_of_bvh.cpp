#include "agents/gait_of_bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <numeric>

#include "agents/skeleton.h"
#include "agents/sole.h"
#include "files/error.h"

namespace prairie {
namespace {

/// Of one side. Below, the names that files give them, the likeliest first, beside "left", "right" or their
/// first letters.
enum Part { kHip, kKnee, kAnkle, kToes, kShoulder, kElbow, kWrist, kPartCount };
constexpr std::array<std::string_view, 5> kHipNames = {"upleg", "thigh", "upperleg", "femur", "hip"};
constexpr std::array<std::string_view, 6> kKneeNames = {"leg", "lowleg", "shin", "calf", "lowerleg", "knee"};
constexpr std::array<std::string_view, 2> kAnkleNames = {"foot", "ankle"};
constexpr std::array<std::string_view, 4> kToesNames = {"toebase", "toes", "toe", "ball"};
constexpr std::array<std::string_view, 5> kShoulderNames = {"arm", "upperarm", "uparm", "shldr", "shoulder"};
constexpr std::array<std::string_view, 4> kElbowNames = {"forearm", "lowerarm", "lowarm", "elbow"};
constexpr std::array<std::string_view, 2> kWristNames = {"hand", "wrist"};
constexpr std::array<std::span<const std::string_view>, kPartCount> kPartNames = {
    kHipNames, kKneeNames, kAnkleNames, kToesNames, kShoulderNames, kElbowNames, kWristNames};
constexpr std::array<std::string_view, kPartCount> kPartShown = {"hip",      "knee",  "ankle", "toes",
                                                                 "shoulder", "elbow", "wrist"};

/// Without case, blanks and punctuation, and without what stands before a colon.
std::string plain_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  if (colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::string plain;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) plain.push_back(static_cast<char>(std::tolower(byte)));
  }
  return plain;
}

/// The joints of a file that a gait is made from.
struct Joints {
  std::array<std::array<std::size_t, kPartCount>, 2> of_side{};
  std::size_t neck = 0;
};

class JointFinder {
 public:
  explicit JointFinder(const BvhMotion& motion) : motion_(motion) {
    for (const BvhJoint& joint : motion.joints) names_.push_back(plain_name(joint.name));
  }

  Joints find() {
    Joints joints;
    for (const bool right : {false, true}) {
      for (int part = 0; part < kPartCount; ++part) {
        auto found = find_part(part, right);
        // Short skeletons end in the foot, and its end site is the toes.
        if (!found && part == kToes && find_part(kAnkle, right))
          found = end_site_of(*find_part(kAnkle, right));
        if (found)
          joints.of_side[right ? 1 : 0][static_cast<std::size_t>(part)] = *found;
        else
          missing_.push_back(
              fmt::format("{} {}", right ? "right" : "left", kPartShown[static_cast<std::size_t>(part)]));
      }
    }
    const auto neck = find_any({"neck", "neck1", "head"});
    if (neck)
      joints.neck = *neck;
    else
      missing_.push_back("neck");
    if (!missing_.empty()) {
      throw BadInput(
          motion_.file, "joints", fmt::format("no {}", fmt::join(missing_, ", no ")),
          "hips, knees, ankles, toes, shoulders, elbows, wrists and a neck under their usual names");
    }
    return joints;
  }

 private:
  std::optional<std::size_t> find_any(std::initializer_list<std::string> wanted) const {
    for (const std::string& name : wanted) {
      const auto found = std::find(names_.begin(), names_.end(), name);
      if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    }
    return std::nullopt;
  }
  std::optional<std::size_t> find_part(int part, bool right) const {
    const std::string word = right ? "right" : "left", letter = right ? "r" : "l";
    for (const std::string_view part_name : kPartNames[static_cast<std::size_t>(part)]) {
      const std::string name(part_name);
      if (const auto found = find_any({word + name, letter + name, name + letter, name + word})) return found;
    }
    return std::nullopt;
  }
  std::optional<std::size_t> end_site_of(std::size_t parent) const {
    for (std::size_t n = parent; n < motion_.joints.size(); ++n) {
      if (motion_.joints[n].parent == static_cast<int>(parent) && motion_.joints[n].name.empty()) return n;
    }
    return std::nullopt;
  }

  const BvhMotion& motion_;
  std::vector<std::string> names_;
  std::vector<std::string> missing_;
};

using Curve = std::vector<double>;

/// A frame, in metres: X along the way, Y to its left, Z up.
struct WalkFrame {
  std::array<std::array<glm::dvec3, kPartCount>, 2> places_m;
  glm::dvec3 neck_m;
  glm::dvec3 hips_m() const { return 0.5 * (places_m[0][kHip] + places_m[1][kHip]); }
};

/// All a gait is measured from.
struct Walk {
  std::string file;
  double frame_s = 0.0;
  double leg_m = 0.0;
  double ankle_m = 0.0;              // height of an ankle whose foot stands flat
  std::array<double, 2> flat_rad{};  // pitch of ankle to toes there
  std::vector<WalkFrame> frames;
};

[[noreturn]] void refuse(const BvhMotion& motion, const std::string& found) {
  throw BadInput(motion.file, "motion", found,
                 "a recorded walk, nearly straight, of at least one whole stride");
}

double quantile(Curve values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double pitch_of(glm::dvec3 bone) {
  return std::atan2(bone.z, std::hypot(bone.x, bone.y));
}

/// The file's frames, Y up, turned so that the walk goes along X.
Walk measured_walk(const BvhMotion& motion, const Joints& joints, std::optional<double> unit_m) {
  Walk walk;
  walk.file = motion.file;
  walk.frame_s = motion.frame_s;
  const std::size_t count = motion.frame_count();
  std::vector<glm::dvec3> places(motion.joints.size());
  const auto show = [&](std::size_t frame) {
    place_joints(motion, frame, places);
    for (glm::dvec3& place : places) place = glm::dvec3(place.z, place.x, place.y);
  };
  const auto at = [&](std::size_t side, int part) {
    return places[joints.of_side[side][static_cast<std::size_t>(part)]];
  };
  const auto hips = [&] { return glm::dvec2(0.5 * (at(0, kHip) + at(1, kHip))); };
  show(count - 1);
  const glm::dvec2 last_hips = hips();
  show(0);
  double leg = 0.0;
  for (std::size_t side : {0, 1}) {
    leg += 0.5 * glm::length(at(side, kKnee) - at(side, kHip));
    leg += 0.5 * glm::length(at(side, kAnkle) - at(side, kKnee));
  }
  if (!(leg > 0.0)) refuse(motion, "legs without length");
  const double unit = unit_m.value_or(kLegM / leg);
  walk.leg_m = unit * leg;

  const glm::dvec2 way = last_hips - hips();
  if (!(unit * glm::length(way) > walk.leg_m)) refuse(motion, "hips that hardly leave their place");
  const glm::dvec2 ahead = glm::normalize(way), left(-ahead.y, ahead.x);
  const auto turned = [&](glm::dvec3 p) {
    const glm::dvec2 flat(p);
    return unit * glm::dvec3(glm::dot(flat, ahead), glm::dot(flat, left), p.z);
  };
  walk.frames.resize(count);
  Curve ankle_heights_m;
  for (std::size_t n = 0; n < count; ++n) {
    show(n);
    WalkFrame& frame = walk.frames[n];
    for (std::size_t side : {0, 1}) {
      for (int part = 0; part < kPartCount; ++part)
        frame.places_m[side][static_cast<std::size_t>(part)] = turned(at(side, part));
      ankle_heights_m.push_back(frame.places_m[side][kAnkle].z);
    }
    frame.neck_m = turned(places[joints.neck]);
    if (!(frame.neck_m.z > frame.hips_m().z && frame.hips_m().z > frame.places_m[0][kAnkle].z))
      refuse(motion, fmt::format("a figure that does not stand along Y in frame {}", n));
  }
  walk.ankle_m = quantile(ankle_heights_m, 0.1);
  for (std::size_t side : {0, 1}) {
    // Flat is what the foot is for most of the time that its ankle is low.
    Curve pitches;
    for (const WalkFrame& frame : walk.frames) {
      if (frame.places_m[side][kAnkle].z < walk.ankle_m + 0.02 * walk.leg_m)
        pitches.push_back(pitch_of(frame.places_m[side][kToes] - frame.places_m[side][kAnkle]));
    }
    if (pitches.empty()) refuse(motion, "a foot that never stands");
    walk.flat_rad[side] = quantile(pitches, 0.5);
  }
  return walk;
}

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
  const Joints joints = JointFinder(motion).find();
  if (motion.frame_count() < 8) refuse(motion, fmt::format("{} frames", motion.frame_count()));
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
    refuse(motion, "no foot that strikes twice and leaves the ground between");
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
    refuse(motion, fmt::format("{:.2f} m/s in strides of {:.2f} s", gait.speed_m_per_s, gait.period_s));
  if (!(gait.stance > 0.45 && gait.stance < 0.75 && gait.lead > 0.2 && gait.lead < 0.7))
    refuse(motion, fmt::format("feet that stand {:.2f} of a stride", gait.stance));
  return gait;
}

}  // namespace prairie
