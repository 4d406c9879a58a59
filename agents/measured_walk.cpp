#include "agents/measured_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "agents/skeleton.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kStrideS = 1.1;  // of a usual walk, over which headings are averaged

glm::dvec3 mean_of(glm::dvec3 a, glm::dvec3 b) {
  return 0.5 * (a + b);
}

/// Frames in the file's unit and orientation.
std::vector<WalkFrame> frames_of(const BvhMotion& motion, const BodyJoints& joints) {
  std::vector<WalkFrame> frames(motion.frame_count());
  std::vector<glm::dvec3> places(motion.joints.size());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    place_joints(motion, n, places);
    for (std::size_t side : {0, 1}) {
      for (std::size_t part = 0; part < kBodyPartCount; ++part)
        frames[n].places_m[side][part] = places[joints.of_side[side][part]];
    }
    frames[n].neck_m = places[joints.neck];
  }
  return frames;
}

template <class Change>
void change_places(std::vector<WalkFrame>& frames, const Change& change) {
  for (WalkFrame& frame : frames) {
    for (auto& of_side : frame.places_m) {
      for (glm::dvec3& place : of_side) place = change(place);
    }
    frame.neck_m = change(frame.neck_m);
  }
}

/// Turns frames so that Z is up, whichever axis was.
void set_upright(std::vector<WalkFrame>& frames) {
  glm::dvec3 body(0.0);
  for (const WalkFrame& frame : frames)
    body += frame.neck_m - mean_of(frame.places_m[0][kAnkle], frame.places_m[1][kAnkle]);
  const glm::dvec3 size = glm::abs(body);
  const int up = size.y >= size.x && size.y >= size.z ? 1 : size.z >= size.x ? 2 : 0;
  const bool is_upside_down = body[up] < 0.0;
  change_places(frames, [=](glm::dvec3 p) {
    const glm::dvec3 turned(p[(up + 1) % 3], p[(up + 2) % 3], p[up]);
    return is_upside_down ? glm::dvec3(turned.x, -turned.y, -turned.z) : turned;
  });
}

double leg_of(const WalkFrame& frame) {
  double leg = 0.0;
  for (const auto& side : frame.places_m) {
    leg += 0.5 * glm::length(side[kKnee] - side[kHip]);
    leg += 0.5 * glm::length(side[kAnkle] - side[kKnee]);
  }
  return leg;
}

double way_length_m(const std::vector<glm::dvec2>& places_m) {
  double length_m = 0.0;
  for (std::size_t n = 1; n < places_m.size(); ++n) length_m += glm::length(places_m[n] - places_m[n - 1]);
  return length_m;
}

/// Means over a stride around each.
std::vector<glm::dvec2> smoothed(const std::vector<glm::dvec2>& values, double frame_s) {
  const auto reach = static_cast<std::ptrdiff_t>(std::max(0.5 * kStrideS / frame_s, 1.0));
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<glm::dvec2> result;
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(n - reach, 0),
                         last = std::min(n + reach, count - 1);
    glm::dvec2 sum(0.0);
    for (std::ptrdiff_t k = first; k <= last; ++k) sum += values[static_cast<std::size_t>(k)];
    result.push_back(sum / static_cast<double>(last - first + 1));
  }
  return result;
}

/// How fast the lower foot goes backwards under the hips, in the middle of all frames.
double speed_under_feet_m_per_s(const std::vector<WalkFrame>& frames, const std::vector<glm::dvec2>& ahead,
                                double frame_s) {
  std::vector<double> speeds;
  const auto reach_m = [&](std::size_t n, std::size_t side) {
    return glm::dot(glm::dvec2(frames[n].places_m[side][kAnkle] - frames[n].hips_m()), ahead[n]);
  };
  for (std::size_t n = 0; n + 1 < frames.size(); ++n) {
    const std::size_t side = frames[n].places_m[0][kAnkle].z < frames[n].places_m[1][kAnkle].z ? 0 : 1;
    speeds.push_back((reach_m(n, side) - reach_m(n + 1, side)) / frame_s);
  }
  return value_at_share(std::move(speeds), 0.5);
}

/// Lays a walk in curves or on the spot along a line.
void straighten(std::vector<WalkFrame>& frames, const BvhMotion& motion, double leg_m) {
  const double frame_s = motion.frame_s;
  std::vector<glm::dvec2> hips_m, facing;
  for (const WalkFrame& frame : frames) {
    hips_m.emplace_back(frame.hips_m());
    const glm::dvec2 leftward(frame.places_m[0][kHip] - frame.places_m[1][kHip]);
    facing.emplace_back(leftward.y, -leftward.x);
  }
  std::vector<glm::dvec2> ahead = smoothed(facing, frame_s);
  for (glm::dvec2& direction : ahead) {
    if (!(glm::length(direction) > 0.0)) refuse_motion(motion, "hips that face no way");
    direction = glm::normalize(direction);
  }
  const std::vector<glm::dvec2> middle_m = smoothed(hips_m, frame_s);
  const double duration_s = frame_s * static_cast<double>(frames.size() - 1);
  const double hips_m_per_s = way_length_m(middle_m) / duration_s;
  const double feet_m_per_s = speed_under_feet_m_per_s(frames, ahead, frame_s);
  const double least_m_per_s = 0.2 * leg_m;
  if (!(feet_m_per_s > least_m_per_s) && !(hips_m_per_s > least_m_per_s)) {
    refuse_motion(motion,
                  fmt::format("hips that go {:.2f} m/s and feet that go {:.2f} m/s under them: nobody walks",
                              hips_m_per_s, feet_m_per_s));
  }
  const bool is_on_the_spot = hips_m_per_s < 0.5 * feet_m_per_s;
  double way_m = 0.0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    if (n > 0) {
      way_m += is_on_the_spot
                   ? feet_m_per_s * frame_s
                   : glm::dot(middle_m[n] - middle_m[n - 1], glm::normalize(ahead[n] + ahead[n - 1]));
    }
    const glm::dvec2 left(-ahead[n].y, ahead[n].x);
    std::vector<WalkFrame> one{frames[n]};
    change_places(one, [&](glm::dvec3 p) {
      const glm::dvec2 from_m = glm::dvec2(p) - middle_m[n];
      return glm::dvec3(way_m + glm::dot(from_m, ahead[n]), glm::dot(from_m, left), p.z);
    });
    frames[n] = one.front();
  }
}

/// Turns a straight walk along X.
void turn_along(std::vector<WalkFrame>& frames, glm::dvec2 way) {
  const glm::dvec2 ahead = glm::normalize(way), left(-ahead.y, ahead.x);
  change_places(frames, [&](glm::dvec3 p) {
    const glm::dvec2 flat(p);
    return glm::dvec3(glm::dot(flat, ahead), glm::dot(flat, left), p.z);
  });
}

bool is_straight(const std::vector<WalkFrame>& frames, double frame_s, double leg_m) {
  std::vector<glm::dvec2> hips_m;
  for (const WalkFrame& frame : frames) hips_m.emplace_back(frame.hips_m());
  const double net_m = glm::length(hips_m.back() - hips_m.front());
  constexpr double kNearlyStraight = 0.9;
  return net_m > leg_m && net_m > kNearlyStraight * way_length_m(smoothed(hips_m, frame_s));
}

void measure_feet(Walk& walk, const BvhMotion& motion) {
  std::vector<double> ankle_heights_m;
  for (const WalkFrame& frame : walk.frames) {
    for (const auto& side : frame.places_m) ankle_heights_m.push_back(side[kAnkle].z);
  }
  walk.ankle_m = value_at_share(std::move(ankle_heights_m), 0.1);
  for (std::size_t side : {0, 1}) {
    // Flat is what the foot is for most of the time that its ankle is low.
    std::vector<double> pitches;
    for (const WalkFrame& frame : walk.frames) {
      if (frame.places_m[side][kAnkle].z < walk.ankle_m + 0.02 * walk.leg_m)
        pitches.push_back(pitch_of(frame.places_m[side][kToes] - frame.places_m[side][kAnkle]));
    }
    if (pitches.empty()) refuse_motion(motion, "a foot that never stands");
    walk.flat_rad[side] = value_at_share(std::move(pitches), 0.5);
  }
}

}  // namespace

void refuse_motion(const BvhMotion& motion, const std::string& found) {
  throw BadInput(motion.file, "motion", found, "a recorded walk of at least one whole stride");
}

double value_at_share(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double pitch_of(glm::dvec3 bone) {
  return std::atan2(bone.z, std::hypot(bone.x, bone.y));
}

Walk measured_walk(const BvhMotion& motion, const BodyJoints& joints, std::optional<double> unit_m) {
  Walk walk;
  walk.file = motion.file;
  walk.frame_s = motion.frame_s;
  walk.frames = frames_of(motion, joints);
  const double leg = leg_of(walk.frames.front());
  if (!(leg > 0.0)) refuse_motion(motion, "legs without length");
  const double unit = unit_m.value_or(kLegM / leg);
  walk.leg_m = unit * leg;
  set_upright(walk.frames);
  change_places(walk.frames, [unit](glm::dvec3 p) { return unit * p; });
  for (std::size_t n = 0; n < walk.frames.size(); ++n) {
    const WalkFrame& frame = walk.frames[n];
    if (!(frame.neck_m.z > frame.hips_m().z && frame.hips_m().z > frame.places_m[0][kAnkle].z))
      refuse_motion(motion, fmt::format("a figure that does not stand upright in frame {}", n));
  }
  if (is_straight(walk.frames, walk.frame_s, walk.leg_m)) {
    turn_along(walk.frames, glm::dvec2(walk.frames.back().hips_m() - walk.frames.front().hips_m()));
  } else {
    straighten(walk.frames, motion, walk.leg_m);
  }
  measure_feet(walk, motion);
  return walk;
}

}  // namespace prairie
