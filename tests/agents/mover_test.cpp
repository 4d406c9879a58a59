#include "agents/mover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "files/error.h"

namespace prairie {
namespace {

/// 100 m × 100 m, the middle at (0, 0).
HeightField ground_of(const std::function<double(glm::dvec2)>& height_m) {
  GridFrame frame;
  frame.columns = 101;
  frame.rows = 101;
  frame.spacing_m = 1.0;
  frame.origin_m = {-50.0, -50.0};
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column)
      heights_m.push_back(static_cast<float>(height_m(frame.origin_m + glm::dvec2(column, row))));
  }
  return HeightField(NodeGrid(frame, 1, std::move(heights_m)));
}

HeightField slope() {
  return ground_of([](glm::dvec2 p) { return 10.0 + 0.4 * p.x - 0.2 * p.y; });
}

HeightField hills() {
  return ground_of([](glm::dvec2 p) { return 2.0 * std::sin(0.15 * p.x) * std::cos(0.12 * p.y); });
}

MoverPath winding(MoverKind kind) {
  MoverPath mover;
  mover.kind = kind;
  mover.radius_m = 0.5;
  mover.speed_m_per_s = 2.0;
  mover.path_m = {{-20.0, -15.0}, {0.0, -10.0}, {12.0, 4.0}, {-3.0, 9.0}, {-18.0, 3.0}};
  return mover;
}

double distance_to_ground_m(const HeightField& ground, glm::dvec3 point_m) {
  double least_m = 1e9;
  for (double x = -1.0; x <= 1.0; x += 0.01) {
    for (double y = -1.0; y <= 1.0; y += 0.01) {
      const glm::dvec2 at_m = glm::dvec2(point_m) + glm::dvec2(x, y);
      const glm::dvec3 on_m(at_m, static_cast<double>(ground.height_m(at_m)));
      least_m = std::min(least_m, glm::length(on_m - point_m));
    }
  }
  return least_m;
}

bool same_bits(const MoverPlace& a, const MoverPlace& b) {
  return a.centre_m == b.centre_m && a.axes == b.axes && a.contact_m == b.contact_m && a.forward == b.forward;
}

TEST(Mover, GoesAtItsSpeed) {
  for (const bool loops : {false, true}) {
    MoverPath path = winding(MoverKind::kStone);
    path.loops = loops;
    const Mover mover(path);
    const HeightField ground = hills();
    constexpr double kStepS = 1.0 / 60.0;
    const double end_s = mover.length_m() / path.speed_m_per_s;
    for (double t = 0.0; t + kStepS < (loops ? 2.5 * end_s : end_s); t += kStepS) {
      const glm::dvec2 from_m = mover.place(ground, t).contact_m,
                       to_m = mover.place(ground, t + kStepS).contact_m;
      ASSERT_NEAR(glm::length(to_m - from_m) / kStepS, path.speed_m_per_s, 0.01 * path.speed_m_per_s) << t;
    }
  }
}

TEST(Mover, StandsBeforeItsStartAndAfterItsEnd) {
  MoverPath path = winding(MoverKind::kCart);
  path.start_s = 5.0;
  const Mover mover(path);
  const HeightField ground = slope();
  EXPECT_EQ(mover.place(ground, 0.0).contact_m, path.path_m.front());
  EXPECT_TRUE(same_bits(mover.place(ground, 0.0), mover.place(ground, 5.0)));
  EXPECT_FALSE(same_bits(mover.place(ground, 5.0), mover.place(ground, 5.1)));
  const double end_s = 5.0 + mover.length_m() / path.speed_m_per_s;
  const MoverPlace last = mover.place(ground, end_s + 1.0), later = mover.place(ground, end_s + 100.0);
  EXPECT_NEAR(glm::length(last.contact_m - path.path_m.back()), 0.0, 1e-6);
  EXPECT_TRUE(same_bits(last, later));
  for (const TreadStep& step : tread_steps(path.kind, path.radius_m, last, later, 0))
    EXPECT_EQ(step.from_m, step.to_m);
}

TEST(Mover, LoopsForEver) {
  MoverPath path = winding(MoverKind::kCart);
  path.loops = true;
  const Mover mover(path);
  const double round_s = mover.length_m() / path.speed_m_per_s;
  const MoverPlace once = mover.place(slope(), 3.0), again = mover.place(slope(), 3.0 + 4.0 * round_s);
  EXPECT_NEAR(glm::length(once.centre_m - again.centre_m), 0.0, 1e-6);
}

TEST(Mover, AStoneRollsWithoutSlipping) {
  const Mover mover(winding(MoverKind::kStone));
  const HeightField level;
  constexpr double kStepS = 1e-4;
  for (double t = 1.0; t < 20.0; t += 0.37) {
    // The point of the stone that touches the ground stands still while the middle moves on.
    const MoverPlace here = mover.place(level, t), next = mover.place(level, t + kStepS);
    const glm::dvec3 touching = glm::transpose(here.axes) * glm::dvec3(0.0, 0.0, -0.5);
    const glm::dvec3 moved = next.centre_m + next.axes * touching - (here.centre_m + here.axes * touching);
    EXPECT_LT(glm::length(moved) / kStepS, 0.02) << t;
    EXPECT_NEAR(glm::length(next.centre_m - here.centre_m) / kStepS, 2.0, 0.02) << t;
    // Its top goes twice as fast, forward.
    const glm::dvec3 top = -touching;
    const glm::dvec3 over = next.centre_m + next.axes * top - (here.centre_m + here.axes * top);
    EXPECT_NEAR(glm::dot(glm::dvec2(over), here.forward) / kStepS, 4.0, 0.04) << t;
  }
}

TEST(Mover, AxesAreARotation) {
  for (const MoverKind kind : {MoverKind::kStone, MoverKind::kCart}) {
    const Mover mover(winding(kind));
    const HeightField ground = hills();
    for (double t = 0.0; t < 30.0; t += 0.1) {
      const glm::dmat3 axes = mover.place(ground, t).axes;
      const glm::dmat3 one = glm::transpose(axes) * axes;
      for (int n = 0; n < 3; ++n) EXPECT_LT(glm::length(one[n] - glm::dmat3(1.0)[n]), 1e-9);
      EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-9);
    }
  }
}

TEST(Mover, AStoneTouchesASlopeAndDoesNotSinkIn) {
  const MoverPath path = winding(MoverKind::kStone);
  const Mover mover(path);
  const HeightField ground = slope();
  for (const double t : {0.0, 7.0, 13.0}) {
    const MoverPlace place = mover.place(ground, t);
    EXPECT_NEAR(distance_to_ground_m(ground, place.centre_m), path.radius_m, 1e-3);
    const glm::dvec3 contact_m(place.contact_m, static_cast<double>(ground.height_m(place.contact_m)));
    EXPECT_NEAR(glm::length(place.centre_m - contact_m), path.radius_m, 1e-5);
  }
}

TEST(Mover, ACartStandsOnItsWheels) {
  for (const HeightField& ground : {slope(), hills()}) {
    const MoverPath path = winding(MoverKind::kCart);
    const Mover mover(path);
    for (double t = 0.0; t < 30.0; t += 0.9) {
      const MoverPlace place = mover.place(ground, t);
      const std::vector<Solid> solids = solids_of(path.kind, path.radius_m, place);
      ASSERT_EQ(solids.size(), 5u);
      const Box& box = std::get<Box>(solids[0]);
      for (std::size_t n = 1; n < solids.size(); ++n) {
        const Capsule& wheel = std::get<Capsule>(solids[n]);
        const glm::dvec3 middle_m = 0.5 * (wheel.from_m + wheel.to_m);
        EXPECT_NEAR(distance_to_ground_m(ground, middle_m), wheel.radius_m, 0.02) << t << ", wheel " << n;
        EXPECT_NEAR(glm::dot(wheel.to_m - wheel.from_m, glm::dvec3(place.forward, 0.0)), 0.0, 0.1);
      }
      EXPECT_GT(glm::dot(box.axes[0], glm::dvec3(place.forward, 0.0)), 0.7);
      EXPECT_GT(distance_to_ground_m(ground, box.centre_m), box.half_size_m.z);
    }
  }
}

TEST(Mover, TreadsWhereItTouches) {
  const HeightField ground = hills();
  const MoverPath stone = winding(MoverKind::kStone), cart = winding(MoverKind::kCart);
  const Mover rolling(stone), riding(cart);
  const auto one =
      tread_steps(stone.kind, stone.radius_m, rolling.place(ground, 4.0), rolling.place(ground, 4.1), 40);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].id, 40u);
  EXPECT_EQ(one[0].from_m, rolling.place(ground, 4.0).contact_m);
  EXPECT_EQ(one[0].to_m, rolling.place(ground, 4.1).contact_m);
  EXPECT_DOUBLE_EQ(one[0].radius_m, 0.3);
  const MoverPlace from = riding.place(ground, 4.0), to = riding.place(ground, 4.1);
  const auto four = tread_steps(cart.kind, cart.radius_m, from, to, 80);
  ASSERT_EQ(four.size(), 4u);
  glm::dvec2 middle_m(0.0);
  for (std::uint32_t n = 0; n < 4; ++n) {
    EXPECT_EQ(four[n].id, 80 + n);
    EXPECT_NEAR(glm::length(four[n].to_m - four[n].from_m), 0.2, 0.05);
    middle_m += 0.25 * four[n].from_m;
  }
  EXPECT_NEAR(glm::length(middle_m - from.contact_m), 0.0, 0.01);
  // A treading takes them.
  Treading treading(TreadSettings{});
  treading.step(four, 0.1);
  EXPECT_GT(treading.sample(four[0].to_m).tilt_rad, 0.0f);
  EXPECT_GT(treading.sample(four[0].to_m).tilt_rad, treading.sample(to.contact_m).tilt_rad);
}

TEST(Mover, IsAFunctionOfTimeAlone) {
  for (const MoverKind kind : {MoverKind::kStone, MoverKind::kCart}) {
    const Mover one(winding(kind)), other(winding(kind));
    const HeightField ground = hills();
    one.place(ground, 25.0);
    for (double t = 0.0; t < 30.0; t += 0.73)
      EXPECT_TRUE(same_bits(one.place(ground, t), other.place(ground, t))) << t;
  }
}

TEST(Mover, RefusesWhatIsNoMover) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refused_field = [](const std::function<void(MoverPath&)>& spoil) -> std::string {
    MoverPath path = winding(MoverKind::kStone);
    spoil(path);
    try {
      const Mover mover(path);
    } catch (const BadInput& fault) {
      EXPECT_FALSE(fault.found.empty());
      EXPECT_FALSE(fault.expected.empty());
      return fault.field;
    }
    return "nothing";
  };
  EXPECT_EQ(refused_field([](MoverPath& p) { p.path_m.clear(); }), "path_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.path_m.resize(1); }), "path_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.path_m = {{1.0, 2.0}, {1.0, 2.0}}; }), "path_m");
  EXPECT_EQ(refused_field([=](MoverPath& p) { p.path_m[1].y = kNan; }), "path_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.path_m[1].x = 1e300; }), "path_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.path_m.resize(10'001); }), "path_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.radius_m = -1.0; }), "radius_m");
  EXPECT_EQ(refused_field([=](MoverPath& p) { p.radius_m = kNan; }), "radius_m");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.speed_m_per_s = -1.0; }), "speed_m_per_s");
  EXPECT_EQ(refused_field([=](MoverPath& p) { p.speed_m_per_s = kNan; }), "speed_m_per_s");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.start_s = std::numeric_limits<double>::infinity(); }),
            "start_s");
  EXPECT_EQ(refused_field([](MoverPath& p) { p.speed_m_per_s = 0.0; }), "nothing");
  EXPECT_EQ(refused_field([](MoverPath& p) {
              p.path_m.clear();
              for (int n = 0; n < 10'000; ++n) p.path_m.emplace_back(n, n % 2);
            }),
            "nothing");
}

}  // namespace
}  // namespace prairie
