#include "agents/gjk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "agents/convex_hull.h"
#include "tests/agents/convex_cases.h"

namespace prairie {
namespace {

using testing::Draw;

template <typename Real>
constexpr double kTight = std::is_same_v<Real, float> ? 4e-6 : 1e-13;

/// Of points along the surfaces, which a distance does not feel.
template <typename Real>
constexpr double kAside = std::is_same_v<Real, float> ? 2e-4 : 1e-12;

template <int D>
glm::vec<D, double> place(Draw& draw, double far_m) {
  glm::vec<D, double> at(0.0);
  for (int axis = 0; axis < D; ++axis) at[axis] = draw.within(-far_m, far_m);
  return at;
}

template <int D, typename Real>
BoxShape<D, Real> random_box(Draw& draw, double far_m) {
  BoxShape<D, Real> box;
  box.centre_m = glm::vec<D, Real>(place<D>(draw, far_m));
  if constexpr (D == 3) {
    box.axes = glm::mat<3, 3, Real>(draw.rotation());
  } else {
    const double angle = draw.within(0.0, 6.3);
    box.axes =
        glm::mat<2, 2, Real>(glm::dmat2(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)));
  }
  for (int axis = 0; axis < D; ++axis) box.half_extents_m[axis] = static_cast<Real>(draw.within(0.1, 1.0));
  return box;
}

std::vector<glm::dvec2> random_polygon(Draw& draw, double far_m) {
  const glm::dvec2 centre = place<2>(draw, far_m);
  const int count = 3 + draw.below(8);
  std::vector<double> angles(static_cast<std::size_t>(count));
  for (double& angle : angles) angle = draw.within(0.0, 2.0 * std::numbers::pi);
  std::ranges::sort(angles);
  std::vector<glm::dvec2> polygon;  // on an ellipse, so that it is convex
  for (const double angle : angles)
    polygon.push_back(centre + glm::dvec2(std::cos(angle), 0.7 * std::sin(angle)));
  return polygon;
}

template <int D>
double to_segment(const glm::vec<D, double>& point, const glm::vec<D, double>& from,
                  const glm::vec<D, double>& to) {
  const glm::vec<D, double> way = to - from;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0.0 ? std::clamp(glm::dot(point - from, way) / length2, 0.0, 1.0) : 0.0;
  return glm::length(point - (from + share * way));
}

/// Of two convex polygons, counter-clockwise, by all normals of their sides: the least overlap, negative if
/// apart.
double overlap_of(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double least = 1e300;
  for (const auto* polygon : {&a, &b}) {
    for (std::size_t n = 0; n < polygon->size(); ++n) {
      const glm::dvec2 side = (*polygon)[(n + 1) % polygon->size()] - (*polygon)[n];
      const glm::dvec2 normal =
          glm::dvec2(side.y, -side.x) / glm::length(side) * (polygon == &a ? 1.0 : -1.0);
      double end_a = -1e300, start_b = 1e300;
      for (const glm::dvec2& point : a) end_a = std::max(end_a, glm::dot(normal, point));
      for (const glm::dvec2& point : b) start_b = std::min(start_b, glm::dot(normal, point));
      least = std::min(least, end_a - start_b);
    }
  }
  return least;
}

double polygon_distance(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double least = 1e300;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      least = std::min({least, to_segment(a[i], b[j], b[(j + 1) % b.size()]),
                        to_segment(b[j], a[i], a[(i + 1) % a.size()])});
    }
  }
  return least;
}

/// By the 15 axes of Gottschalk, Lin & Manocha 1996, OBBTree, in all of which boxes that overlap must
/// overlap.
double overlap_of(const BoxShape<3, double>& a, const BoxShape<3, double>& b) {
  double least = 1e300;
  const auto along = [&](glm::dvec3 axis) {
    const double length = glm::length(axis);
    if (length < 1e-6) return;
    axis /= length;
    double reach = -std::abs(glm::dot(axis, b.centre_m - a.centre_m));
    for (int n = 0; n < 3; ++n)
      reach += a.half_extents_m[n] * std::abs(glm::dot(axis, a.axes[n])) +
               b.half_extents_m[n] * std::abs(glm::dot(axis, b.axes[n]));
    least = std::min(least, reach);
  };
  for (int i = 0; i < 3; ++i) {
    along(a.axes[i]);
    along(b.axes[i]);
    for (int j = 0; j < 3; ++j) along(glm::cross(a.axes[i], b.axes[j]));
  }
  return least;
}

// How far outside of a shape a point is.
template <int D, typename Real>
double outside(const SphereShape<D, Real>& shape, const glm::vec<D, double>& point) {
  return glm::length(point - glm::vec<D, double>(shape.centre_m)) - static_cast<double>(shape.radius_m);
}
template <int D, typename Real>
double outside(const CapsuleShape<D, Real>& shape, const glm::vec<D, double>& point) {
  return to_segment<D>(point, glm::vec<D, double>(shape.from_m), glm::vec<D, double>(shape.to_m)) -
         static_cast<double>(shape.radius_m);
}
template <int D, typename Real>
double outside(const BoxShape<D, Real>& shape, const glm::vec<D, double>& point) {
  double most = -1e300;
  for (int axis = 0; axis < D; ++axis) {
    const double along =
        glm::dot(point - glm::vec<D, double>(shape.centre_m), glm::vec<D, double>(shape.axes[axis]));
    most = std::max(most, std::abs(along) - static_cast<double>(shape.half_extents_m[axis]));
  }
  return most;
}

template <typename A, typename B>
void holds_together(const A& a, const B& b) {
  const auto found = shape_distance(a, b);
  using Vector = std::remove_cvref_t<decltype(found.normal)>;
  using Wide = glm::vec<Vector::length(), double>;
  constexpr double tolerance = kTight<typename Vector::value_type>;
  const Wide on_a(found.point_on_a_m), on_b(found.point_on_b_m), normal(found.normal);
  const double distance = static_cast<double>(found.distance_m);
  EXPECT_NEAR(glm::length(normal), 1.0, tolerance);
  EXPECT_LT(glm::length(on_b - on_a - distance * normal), kAside<typename Vector::value_type>);
  EXPECT_NEAR(glm::dot(on_b - on_a, normal), distance, 8.0 * tolerance);
  EXPECT_NEAR(outside(a, on_a), 0.0, 8.0 * tolerance);
  EXPECT_NEAR(outside(b, on_b), 0.0, 8.0 * tolerance);

  const auto back = shape_distance(b, a);
  EXPECT_NEAR(static_cast<double>(back.distance_m), distance, 4.0 * tolerance);

  GjkCache cache;
  shape_distance(a, b, cache);
  const auto again = shape_distance(a, b, cache);
  EXPECT_NEAR(static_cast<double>(again.distance_m), distance, 4.0 * tolerance);
  EXPECT_LE(again.iterations, found.iterations);
}

template <int D, typename Real>
void all_kinds_hold_together() {
  Draw draw(7);
  for (int n = 0; n < 2000; ++n) {
    const BoxShape<D, Real> box = random_box<D, Real>(draw, 1.5), other = random_box<D, Real>(draw, 1.5);
    const SphereShape<D, Real> sphere{glm::vec<D, Real>(place<D>(draw, 1.5)),
                                      static_cast<Real>(draw.within(0.0, 1.0))};
    const SphereShape<D, Real> ball{glm::vec<D, Real>(place<D>(draw, 1.5)),
                                    static_cast<Real>(draw.within(0.0, 1.0))};
    const CapsuleShape<D, Real> capsule{glm::vec<D, Real>(place<D>(draw, 1.5)),
                                        glm::vec<D, Real>(place<D>(draw, 1.5)),
                                        static_cast<Real>(draw.within(0.0, 0.6))};
    const CapsuleShape<D, Real> rod{glm::vec<D, Real>(place<D>(draw, 1.5)),
                                    glm::vec<D, Real>(place<D>(draw, 1.5)),
                                    static_cast<Real>(draw.within(0.0, 0.6))};
    SCOPED_TRACE(n);
    holds_together(box, other);
    holds_together(box, sphere);
    holds_together(box, capsule);
    holds_together(sphere, ball);
    holds_together(sphere, capsule);
    holds_together(capsule, rod);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Gjk, PointsLieOnTheShapesAsFarApartAsItSays) {
  all_kinds_hold_together<3, double>();
  all_kinds_hold_together<3, float>();
  all_kinds_hold_together<2, double>();
  all_kinds_hold_together<2, float>();
}

TEST(Gjk, RoundShapesMatchClosedForms) {
  Draw draw(3);
  for (int n = 0; n < 20'000; ++n) {
    const SphereShape<3, double> a{2.0 * draw.in_cube(), draw.unit()}, b{2.0 * draw.in_cube(), draw.unit()};
    const CapsuleShape<3, double> rod{2.0 * draw.in_cube(), 2.0 * draw.in_cube(), draw.unit()};
    EXPECT_NEAR(shape_distance(a, b).distance_m,
                glm::length(a.centre_m - b.centre_m) - a.radius_m - b.radius_m, 1e-14);
    EXPECT_NEAR(shape_distance(a, rod).distance_m,
                to_segment<3>(a.centre_m, rod.from_m, rod.to_m) - a.radius_m - rod.radius_m, 1e-14);
  }
}

TEST(Gjk, PolygonsMatchBruteForce) {
  Draw draw(4);
  int overlapping = 0;
  for (int n = 0; n < 20'000; ++n) {
    const std::vector<glm::dvec2> a = random_polygon(draw, 1.5), b = random_polygon(draw, 1.5);
    const double overlap = overlap_of(a, b);
    const double distance =
        shape_distance(ConvexVertices<2, double>{a}, ConvexVertices<2, double>{b}).distance_m;
    ASSERT_NEAR(distance, overlap > 0.0 ? -overlap : polygon_distance(a, b), 1e-12) << n;
    overlapping += overlap > 0.0;

    const std::vector<glm::vec2> rough_a(a.begin(), a.end()), rough_b(b.begin(), b.end());
    const float rough =
        shape_distance(ConvexVertices<2, float>{rough_a}, ConvexVertices<2, float>{rough_b}).distance_m;
    ASSERT_NEAR(static_cast<double>(rough), distance, 1e-5) << n;
  }
  EXPECT_GT(overlapping, 2000);
}

TEST(Gjk, BoxesAreAsDeepAsTheirLeastOverlap) {
  Draw draw(5);
  int overlapping = 0;
  for (int n = 0; n < 20'000; ++n) {
    const BoxShape<3, double> a = random_box<3, double>(draw, 0.7), b = random_box<3, double>(draw, 0.7);
    const double overlap = overlap_of(a, b);
    const ShapeDistance<3, double> found = shape_distance(a, b);
    ASSERT_EQ(found.distance_m<0.0, overlap> 0.0) << n;
    if (overlap <= 0.0) continue;
    ++overlapping;
    ASSERT_NEAR(found.distance_m, -overlap, 1e-13) << n;
    BoxShape<3, double> moved = b;
    moved.centre_m -= found.distance_m * found.normal;
    ASSERT_NEAR(shape_distance(a, moved).distance_m, 0.0, 1e-13) << n;
  }
  EXPECT_GT(overlapping, 5000);
}

TEST(Gjk, CoincidentAndNestedShapesHaveADepth) {
  const SphereShape<2, double> disc{{3.0, 4.0}, 0.5};
  EXPECT_EQ(shape_distance(disc, disc).distance_m, -1.0);
  EXPECT_NEAR(glm::length(shape_distance(disc, disc).normal), 1.0, 1e-15);

  const BoxShape<3, double> cube{{0.0, 0.0, 0.0}, glm::dmat3(1.0), {1.0, 1.0, 1.0}};
  EXPECT_NEAR(shape_distance(cube, cube).distance_m, -2.0, 1e-14);
  const ShapeDistance<3, double> found = shape_distance(cube, SphereShape<3, double>{{0.5, 0.0, 0.0}, 0.25});
  EXPECT_NEAR(found.distance_m, -0.75, 1e-14);
  EXPECT_NEAR(found.normal.x, 1.0, 1e-14);

  const CapsuleShape<3, double> along{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.1},
      across{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 0.1};
  EXPECT_NEAR(shape_distance(along, across).distance_m, -0.2, 1e-14);
  EXPECT_NEAR(std::abs(shape_distance(along, across).normal.z), 1.0, 1e-14);
  EXPECT_NEAR(shape_distance(along, along).distance_m, -0.2, 1e-14);
}

TEST(Gjk, KeepsItsPrecisionFarFromTheOrigin) {
  Draw draw(6);
  for (int n = 0; n < 5000; ++n) {
    BoxShape<3, double> a = random_box<3, double>(draw, 2.0), b = random_box<3, double>(draw, 2.0);
    a.centre_m = testing::dyadic(a.centre_m);
    b.centre_m = testing::dyadic(b.centre_m);
    const double near = shape_distance(a, b).distance_m;
    const glm::dvec3 way(6'000'000.0, -4'000'000.0, 500.0);
    a.centre_m += way;
    b.centre_m += way;
    ASSERT_NEAR(shape_distance(a, b).distance_m, near, 1e-14) << n;
  }
}

TEST(Gjk, FollowsMovingShapesFromItsCache) {
  Draw draw(8);
  int iterations = 0, cold_iterations = 0;
  for (int n = 0; n < 200; ++n) {
    const BoxShape<3, double> a = random_box<3, double>(draw, 0.5);
    BoxShape<3, double> b = random_box<3, double>(draw, 0.5);
    b.centre_m += 3.0 * draw.direction();
    const glm::dvec3 way = 0.01 * draw.direction();
    GjkCache cache;
    for (int step = 0; step < 200; ++step) {
      const ShapeDistance<3, double> warm = shape_distance(a, b, cache), cold = shape_distance(a, b);
      ASSERT_NEAR(warm.distance_m, cold.distance_m, 1e-12);
      if (cold.distance_m > 0.0) {
        iterations += warm.iterations;
        cold_iterations += cold.iterations;
      }
      b.centre_m += way;
    }
  }
  EXPECT_LT(iterations, cold_iterations / 2);
}

TEST(Gjk, ClimbsAHullToTheSamePointAsAScan) {
  Draw draw(9);
  for (int n = 0; n < 40; ++n) {
    std::vector<glm::dvec3> points;
    for (int point = 0; point < 200; ++point)
      points.push_back(draw.direction() * glm::dvec3(1.0, 0.6, n % 2 ? 0.01 : 0.8));
    const ConvexHull hull = convex_hull(points);
    ASSERT_GT(hull.vertices_m.size(), kLeastClimbedVertices);
    const BoxShape<3, double> box = random_box<3, double>(draw, 0.5);
    for (int pose = 0; pose < 50; ++pose) {
      PlacedHull<double> climbed = placed(hull, 2.0 * draw.in_cube(), draw.rotation());
      PlacedHull<double> scanned = climbed;
      scanned.neighbours = {};
      ASSERT_NEAR(shape_distance(climbed, box).distance_m, shape_distance(scanned, box).distance_m, 1e-12);
      ASSERT_NEAR(shape_distance(box, climbed).distance_m, shape_distance(climbed, box).distance_m, 1e-12);
    }
  }
}

/// Sizes, distances and radii from 1e-6 to 1e6, any of them 0.
template <int D, typename Real>
void always_answers(int pairs, std::uint64_t seed) {
  Draw draw(seed);
  const auto length = [&] { return draw.below(8) == 0 ? Real(0) : static_cast<Real>(draw.size(1e-6, 1e6)); };
  const auto point = [&] {
    glm::vec<D, Real> at(Real(0));
    const double reach = draw.size(1e-6, 1e6);
    for (int axis = 0; axis < D; ++axis)
      at[axis] = static_cast<Real>(draw.below(4) == 0 ? 0.0 : draw.within(-reach, reach));
    return at;
  };
  GjkCache cache;  // of whatever pair came before
  const auto ask = [&](const auto& a, const auto& b) {
    for (const bool is_warm : {false, true}) {
      GjkCache none;
      const ShapeDistance<D, Real> found = shape_distance(a, b, is_warm ? cache : none);
      ASSERT_TRUE(std::isfinite(found.distance_m));
      for (int axis = 0; axis < D; ++axis) {
        ASSERT_TRUE(std::isfinite(found.point_on_a_m[axis]) && std::isfinite(found.point_on_b_m[axis]) &&
                    std::isfinite(found.normal[axis]));
      }
      ASSERT_NEAR(static_cast<double>(glm::dot(found.normal, found.normal)), 1.0, 1e-4);
      ASSERT_LT(found.iterations, 1000);
    }
  };
  for (int n = 0; n < pairs; ++n) {
    SCOPED_TRACE(n);
    const SphereShape<D, Real> sphere{point(), length()};
    const CapsuleShape<D, Real> capsule{point(), point(), length()};
    BoxShape<D, Real> box = random_box<D, Real>(draw, 1.0);
    box.centre_m = point();
    for (int axis = 0; axis < D; ++axis) box.half_extents_m[axis] = length();
    std::vector<glm::vec<D, Real>> points(static_cast<std::size_t>(1 + draw.below(9)));
    for (auto& at : points) at = point();
    const ConvexVertices<D, Real> vertices{points};
    switch (n % 8) {
      case 0:
        ask(sphere, capsule);
        break;
      case 1:
        ask(sphere, box);
        break;
      case 2:
        ask(sphere, vertices);
        break;
      case 3:
        ask(capsule, box);
        break;
      case 4:
        ask(capsule, vertices);
        break;
      case 5:
        ask(box, vertices);
        break;
      case 6:
        ask(box, random_box<D, Real>(draw, 1.0));
        break;
      default:
        ask(vertices, vertices);
        break;
    }
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Gjk, AlwaysAnswers) {
  always_answers<3, double>(25'000, 11);
  always_answers<3, float>(25'000, 12);
  always_answers<2, double>(25'000, 13);
  always_answers<2, float>(25'000, 14);
}

}  // namespace
}  // namespace prairie
