#include "agents/walker_pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "animation/heading.h"

namespace prairie {
namespace {

constexpr double kStepS = 1.0 / 60.0;

/// 200 m × 200 m, the middle at (0, 0).
HeightField ground_of(const std::function<double(glm::dvec2)>& height_m) {
  GridFrame frame;
  frame.columns = 201;
  frame.rows = 201;
  frame.spacing_m = 1.0;
  frame.origin_m = {-100.0, -100.0};
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column)
      heights_m.push_back(static_cast<float>(height_m(frame.origin_m + glm::dvec2(column, row))));
  }
  return HeightField(NodeGrid(frame, 1, std::move(heights_m)));
}

/// Rises by 20 degrees towards a heading.
HeightField slope_towards(double heading_rad) {
  const glm::dvec2 up = 0.36397 * direction_of(heading_rad);
  return ground_of([up](glm::dvec2 p) { return up.x * p.x + up.y * p.y; });
}

struct SolePoints {
  glm::dvec3 heel_m, ball_m;
};

/// Of the drawn foot: below its heel, and below the joint of its toes, which lie flat.
SolePoints sole_of(const WalkerPose& pose, bool right, double scale) {
  const JointFrame& ankle = pose[index_of(on_side(Joint::kLeftAnkle, right))];
  const JointFrame& toes = pose[index_of(on_side(Joint::kLeftToes, right))];
  return {ankle.place_m + scale * (ankle.axes * glm::dvec3(-kHeelBehindM, 0.0, -kAnkleHeightM)),
          toes.place_m + scale * (toes.axes * glm::dvec3(0.0, 0.0, -kToesHeightM))};
}

double over_ground_m(const HeightField& ground, glm::dvec3 point_m) {
  return point_m.z - static_cast<double>(ground.height_m(glm::dvec2(point_m)));
}

/// What bar of the drawn figure is worst, over a walk.
struct Worst {
  double slide_m = 0.0;        // of the point of a sole that carries, over a stance
  double off_ground_m = 0.0;   // of a standing foot's lowest point
  double in_ground_m = 0.0;    // of any point of any sole
  double unreached_m = 0.0;    // of feet that the legs had to pull
  double jump_m = 0.0;         // of a joint's place from where its last two would lead it
  double speed_m_per_s = 0.0;  // of a joint
  double least_knee = 1.0;     // sine of the knee's bend, forward
  double most_knee_rad = 0.0;
  double least_pelvis_m = 10.0;  // over the ground
};

struct Walk {
  const HeightField& ground;
  double scale = 1.0;
  Footing footing = standing({0.0, 0.0}, {1.0, 0.0}, scale);
  BodyStep body{};
  double heading_rad = 0.0;
  double speed_m_per_s = 0.0;
  Worst worst{};
  WalkerPose last{};
  WalkerPose before_last{};
  int steps = 0;
  struct Stance {
    glm::dvec3 heel_m{0.0}, ball_m{0.0};
    bool on_ball = false;
  };
  std::array<Stance, 2> struck{};

  explicit Walk(const HeightField& on, double heading = 0.0, double size = 1.0)
      : ground(on),
        scale(size),
        footing(standing({0.0, 0.0}, direction_of(heading), size)),
        heading_rad(heading) {}

  void step(double wanted_m_per_s, double turn_rad_per_s) {
    heading_rad += turn_rad_per_s * kStepS;
    speed_m_per_s += std::clamp(wanted_m_per_s - speed_m_per_s, -2.0 * kStepS, 2.0 * kStepS);
    body.forward = direction_of(heading_rad);
    body.speed_m_per_s = speed_m_per_s;
    body.position_m += speed_m_per_s * kStepS * body.forward;
    body.grade = glm::dot(glm::dvec2(ground.slope(body.position_m)), body.forward);
    const Footing before = footing;
    advance(footing, recorded_gait(), body, kStepS);
    const WalkerPose pose = pose_of(recorded_gait(), footing, body.position_m, body.forward, ground);
    measure(before, pose);
    before_last = last;
    last = pose;
    ++steps;
  }
  void walk(double seconds, double wanted_m_per_s, double turn_rad_per_s = 0.0) {
    for (double t = 0.0; t < seconds; t += kStepS) step(wanted_m_per_s, turn_rad_per_s);
  }

 private:
  void measure(const Footing& before, const WalkerPose& pose) {
    for (const bool right : {false, true}) {
      const std::size_t n = right ? 1 : 0;
      const SolePoints sole = sole_of(pose, right, scale);
      const double heel_m = over_ground_m(ground, sole.heel_m), ball_m = over_ground_m(ground, sole.ball_m);
      worst.in_ground_m = std::max(worst.in_ground_m, -std::min(heel_m, ball_m));
      const glm::dvec3 hip_m = pose[index_of(on_side(Joint::kLeftHip, right))].place_m;
      const JointFrame& knee = pose[index_of(on_side(Joint::kLeftKnee, right))];
      const JointFrame& ankle = pose[index_of(on_side(Joint::kLeftAnkle, right))];
      if (footing.feet[n].planted) {
        worst.off_ground_m = std::max(worst.off_ground_m, std::min(heel_m, ball_m));
        // The heel carries until the foot is flat, the ball from then on.
        const bool strikes = !before.feet[n].planted || steps == 0, on_ball = ball_m <= heel_m + 0.002;
        if (strikes) struck[n] = {.heel_m = sole.heel_m, .ball_m = sole.ball_m, .on_ball = false};
        if (on_ball && !struck[n].on_ball) struck[n] = {struck[n].heel_m, sole.ball_m, true};
        worst.slide_m = std::max(worst.slide_m, on_ball ? glm::distance(sole.ball_m, struck[n].ball_m)
                                                        : glm::distance(sole.heel_m, struck[n].heel_m));
      }
      const glm::dvec3 thigh = glm::normalize(hip_m - knee.place_m),
                       shank = glm::normalize(knee.place_m - ankle.place_m);
      const double bend = glm::dot(glm::cross(thigh, shank), knee.axes[1]);
      worst.least_knee = std::min(worst.least_knee, bend);
      // The knee's front faces ahead.
      EXPECT_GT(glm::dot(knee.axes[0], glm::dvec3(body.forward, 0.0)), 0.0);
      worst.most_knee_rad =
          std::max(worst.most_knee_rad, std::acos(std::clamp(glm::dot(thigh, shank), -1.0, 1.0)));
      worst.unreached_m =
          std::max(worst.unreached_m, std::abs(glm::distance(knee.place_m, ankle.place_m) - scale * kShankM));
    }
    const glm::dvec3 pelvis_m = pose[0].place_m;
    worst.least_pelvis_m = std::min(worst.least_pelvis_m, over_ground_m(ground, pelvis_m));
    if (steps < 2) return;
    for (std::size_t n = 0; n < kJointCount; ++n) {
      const glm::dvec3 moved_m = pose[n].place_m - last[n].place_m;
      worst.speed_m_per_s = std::max(worst.speed_m_per_s, glm::length(moved_m) / kStepS);
      worst.jump_m =
          std::max(worst.jump_m, glm::length(moved_m - (last[n].place_m - before_last[n].place_m)));
    }
  }
};

void expect_bars(const Worst& worst) {
  EXPECT_LE(worst.slide_m, 0.02);
  EXPECT_LE(worst.off_ground_m, 0.02);
  EXPECT_LE(worst.in_ground_m, 0.02);
  EXPECT_GE(worst.least_knee, 0.05);
  EXPECT_LE(worst.most_knee_rad, 2.2);
  EXPECT_LE(worst.jump_m, 0.06);  // of a knee that straightens, at 2 m/s
  EXPECT_LE(worst.speed_m_per_s, 9.0);
  EXPECT_LE(worst.unreached_m, 1e-6);
}

TEST(WalkerPose, StandsUprightWithFlatFeet) {
  const HeightField level;
  const Footing footing = standing({3.0, 4.0}, {1.0, 0.0}, 1.0);
  const WalkerPose pose = pose_of(recorded_gait(), footing, {3.0, 4.0}, {1.0, 0.0}, level);
  EXPECT_NEAR(pose[index_of(Joint::kHead)].place_m.z, 1.55, 0.03);
  for (const bool right : {false, true}) {
    EXPECT_NEAR(sole_of(pose, right, 1.0).heel_m.z, 0.0, 1e-5);
    EXPECT_NEAR(sole_of(pose, right, 1.0).ball_m.z, 0.0, 1e-5);
  }
  for (const JointFrame& frame : pose) EXPECT_NEAR(glm::determinant(frame.axes), 1.0, 1e-5);
}

TEST(WalkerPose, FeetStandOnLevelGroundAtEverySpeed) {
  const HeightField level;
  for (const double speed : {0.0, 0.2, 0.5, 0.8, 1.18, 1.6, 2.0}) {
    SCOPED_TRACE(speed);
    Walk walk(level);
    walk.walk(8.0, speed);
    walk.walk(2.5, 0.0);
    expect_bars(walk.worst);
    EXPECT_GT(walk.worst.least_pelvis_m, 0.78);
  }
}

TEST(WalkerPose, FeetStandOnSlopesOfTwentyDegrees) {
  for (const double heading : {0.0, 0.785, 1.571, 2.356, 3.142}) {
    const HeightField slope = slope_towards(0.0);
    for (const double speed : {0.6, 1.18, 1.6}) {
      SCOPED_TRACE(testing::Message() << "heading " << heading << " speed " << speed);
      Walk walk(slope, heading);
      walk.walk(8.0, speed);
      walk.walk(2.5, 0.0);
      expect_bars(walk.worst);
      EXPECT_GT(walk.worst.least_pelvis_m, 0.68);
    }
  }
}

TEST(WalkerPose, FeetStandAlongCurvesAndOnHills) {
  const HeightField hills =
      ground_of([](glm::dvec2 p) { return 2.0 * std::sin(0.15 * p.x) * std::cos(0.12 * p.y); });
  for (const double turn : {-0.8, -0.3, 0.3, 0.8}) {
    SCOPED_TRACE(turn);
    Walk walk(hills, 0.4);
    walk.walk(12.0, 1.18, turn);
    walk.walk(3.0, 0.0, turn);
    walk.walk(4.0, 1.8, -turn);
    expect_bars(walk.worst);
  }
}

TEST(WalkerPose, WalkersOfOtherHeightsWalkAsWell) {
  const HeightField level;
  for (const double scale : {0.7, 0.9, 1.12}) {
    SCOPED_TRACE(scale);
    Walk walk(level, 0.0, scale);
    walk.walk(6.0, 1.2);
    expect_bars(walk.worst);
  }
}

TEST(WalkerPose, BonesKeepTheirLengths) {
  const HeightField slope = slope_towards(0.5);
  Walk walk(slope);
  walk.walk(3.0, 1.3, 0.4);
  for (std::size_t n = 1; n < kJointCount; ++n) {
    const std::size_t parent = index_of(kRestSkeleton[n].parent);
    EXPECT_NEAR(glm::distance(walk.last[n].place_m, walk.last[parent].place_m),
                glm::distance(kRestSkeleton[n].place_m, kRestSkeleton[parent].place_m), 2e-3)
        << n;
  }
}

}  // namespace
}  // namespace prairie
