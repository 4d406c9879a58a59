// How deep shapes are in one another that lie as made things do, against closed forms and against CGAL's
// exact hull of their difference.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "agents/gjk.h"
#include "tests/agents/aligned_shapes.h"

namespace prairie {
namespace {

using testing::AlignedBoxes;
using testing::Draw;
using testing::Points;

constexpr int kPairs = 100'000, kManyPairs = 1'000'000;
constexpr int kExactPairs = 1'000, kManyExactPairs = 10'000;
constexpr double kSizeM = 2.0;  // of the families' larger shapes
template <typename Real>
constexpr double kAllowedM = (std::is_same_v<Real, float> ? 1e-5 : 1e-9) * kSizeM;

/// Larger errors than allowed, and pairs told on the wrong side; in both orders.
template <typename Real>
struct Tally {
  int wrong = 0;
  double worst_m = 0.0;

  template <typename A, typename B>
  void take(const A& a, const B& b, double expected_m) {
    for (const double told_m : {static_cast<double>(shape_distance(a, b).distance_m),
                                static_cast<double>(shape_distance(b, a).distance_m)}) {
      const double error_m = std::isfinite(told_m) ? std::abs(told_m - expected_m) : 1e300;
      worst_m = std::max(worst_m, error_m);
      if (!(error_m <= kAllowedM<Real>)) ++wrong;
    }
  }
  void check(const std::string& name) const {
    EXPECT_EQ(wrong, 0) << name << ", worst by " << worst_m << " m";
    ::testing::Test::RecordProperty("worst_m_of_" + name, fmt::format("{:.1e}", worst_m));
  }
};

template <typename Real>
BoxShape<3, Real> as(const BoxShape<3, double>& box) {
  return {.centre_m = glm::vec<3, Real>(box.centre_m),
          .axes = glm::mat<3, 3, Real>(box.axes),
          .half_extents_m = glm::vec<3, Real>(box.half_extents_m)};
}

template <typename Real>
void boxes(int pairs) {
  for (int family = 0; family < testing::kBoxFamilies; ++family) {
    Draw draw(static_cast<std::uint64_t>(family + 1));
    Tally<Real> tally;
    for (int n = 0; n < pairs; ++n) {
      const AlignedBoxes pair = testing::box_pair(family, draw);
      tally.take(as<Real>(pair.a), as<Real>(pair.b), pair.distance_m);
    }
    tally.check(testing::name_of_box_family(family));
  }
}

/// Where two stretches of one line lie, given by their ends.
double gap_of_stretches(double a0, double a1, double b0, double b1) {
  return std::max({std::min(b0, b1) - std::max(a0, a1), std::min(a0, a1) - std::max(b0, b1), 0.0});
}

template <int D, typename Real>
void capsules_on_one_line(int pairs) {
  Draw draw(31);
  Tally<Real> tally;
  for (int n = 0; n < pairs; ++n) {
    using Vector = glm::vec<D, double>;
    const Vector from(draw.in_cube());
    const Vector along = glm::normalize(Vector(draw.direction()) + Vector(1e-3));
    const double b0 = 0.5 * draw.within(-1, 1), b1 = 1.0 + 0.5 * draw.within(-1, 1);
    const CapsuleShape<D, Real> a{glm::vec<D, Real>(from), glm::vec<D, Real>(from + along), Real(0.1)};
    const CapsuleShape<D, Real> b{glm::vec<D, Real>(from + b0 * along), glm::vec<D, Real>(from + b1 * along),
                                  Real(0.2)};
    tally.take(a, b, gap_of_stretches(0.0, 1.0, b0, b1) - 0.1 - 0.2);
  }
  tally.check("capsules on one line");
}

/// A capsule along an axis of a box, and a ball, inside or not.
template <typename Real>
void round_things_in_a_box(int pairs) {
  Draw draw(32);
  Tally<Real> capsules, balls;
  for (int n = 0; n < pairs; ++n) {
    const glm::dmat3 axes = draw.rotation();
    const BoxShape<3, double> box{draw.in_cube(), axes, {0.8, 0.5, 0.3}};
    const glm::dvec3 at = glm::dvec3(0.7, 0.45, 0.28) * draw.in_cube();
    const double half_length = draw.within(0.0, 0.5), radius = 0.05;
    const glm::dvec3 middle = box.centre_m + axes * at;
    const auto point = [](const glm::dvec3& place) { return glm::vec<3, Real>(place); };
    const CapsuleShape<3, Real> capsule{point(middle - half_length * axes[0]),
                                        point(middle + half_length * axes[0]), static_cast<Real>(radius)};
    capsules.take(
        as<Real>(box), capsule,
        testing::distance_of_extents<3>(at, box.half_extents_m + glm::dvec3(half_length, 0, 0)) - radius);
    balls.take(as<Real>(box), SphereShape<3, Real>{point(middle), static_cast<Real>(radius)},
               testing::distance_of_extents<3>(at, box.half_extents_m) - radius);
  }
  capsules.check("capsules along an axis of a box");
  balls.check("balls in a box");
}

template <typename Real>
void hulls_of_many_points_in_one_plane(int pairs) {
  Draw draw(33);
  Tally<Real> tally;
  for (int n = 0; n < pairs; ++n) {
    const AlignedBoxes pair = testing::box_pair(n % 3, draw);
    std::vector<glm::vec<3, Real>> a, b;
    for (const glm::dvec3& point : testing::crowded_box(pair.a)) a.emplace_back(point);
    for (const glm::dvec3& point : testing::crowded_box(pair.b)) b.emplace_back(point);
    tally.take(ConvexVertices<3, Real>{a}, ConvexVertices<3, Real>{b}, pair.distance_m);
  }
  tally.check("hulls of many points in one plane");
}

template <typename Real>
void boxes_in_the_plane(int pairs) {
  Draw draw(34);
  Tally<Real> tally;
  for (int n = 0; n < pairs; ++n) {
    const double angle = draw.within(-3.2, 3.2);
    const glm::dmat2 axes{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}};
    const glm::dvec2 half = n % 3 == 0 ? glm::dvec2(1.0, 0.001) : glm::dvec2(0.5, 0.3);
    const glm::dvec2 centre(draw.in_cube());
    const glm::dvec2 between = n % 2 == 0 ? glm::dvec2(0.0) : glm::dvec2(draw.within(-1, 1), 0.0);
    const BoxShape<2, Real> a{glm::vec<2, Real>(centre), glm::mat<2, 2, Real>(axes), glm::vec<2, Real>(half)};
    BoxShape<2, Real> b = a;
    b.centre_m = glm::vec<2, Real>(centre + axes * between);
    tally.take(a, b, testing::distance_of_extents<2>(between, half + half));
  }
  tally.check("boxes of one turn in the plane");
}

template <typename Real>
void all_families(int pairs) {
  boxes<Real>(pairs);
  capsules_on_one_line<3, Real>(pairs);
  capsules_on_one_line<2, Real>(pairs);
  round_things_in_a_box<Real>(pairs);
  hulls_of_many_points_in_one_plane<Real>(pairs);
  boxes_in_the_plane<Real>(pairs);
}

TEST(GjkDepth, AgreesWithClosedFormsInDouble) {
  all_families<double>(kPairs);
}
TEST(GjkDepth, AgreesWithClosedFormsInFloat) {
  all_families<float>(kPairs);
}
TEST(GjkDepthLongTest, AgreesWithClosedFormsInDouble) {
  all_families<double>(kManyPairs);
}
TEST(GjkDepthLongTest, AgreesWithClosedFormsInFloat) {
  all_families<float>(kManyPairs);
}

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

/// Of shapes that overlap, positive: from the origin to the nearest side of the hull of all differences.
double exact_depth(const Points& a, const Points& b) {
  std::vector<Exact::Point_3> differences;
  for (const glm::dvec3& p : a) {
    for (const glm::dvec3& q : b)
      differences.emplace_back(Exact::FT(p.x) - Exact::FT(q.x), Exact::FT(p.y) - Exact::FT(q.y),
                               Exact::FT(p.z) - Exact::FT(q.z));
  }
  CGAL::Surface_mesh<Exact::Point_3> hull;
  CGAL::convex_hull_3(differences.begin(), differences.end(), hull);
  double depth = std::numeric_limits<double>::max();
  for (const auto face : hull.faces()) {
    const auto side = hull.halfedge(face);
    const Exact::Plane_3 plane(hull.point(hull.source(side)), hull.point(hull.target(side)),
                               hull.point(hull.target(hull.next(side))));
    const Exact::FT squared =
        plane.d() * plane.d() / (plane.a() * plane.a() + plane.b() * plane.b() + plane.c() * plane.c());
    depth = std::min(depth, std::sqrt(CGAL::to_double(squared)));
  }
  return depth;
}

/// Points of two shapes of one of the families; the corners of boxes, the ends of a capsule's core, a ball's
/// middle.
struct Family {
  const char* name;
  std::function<testing::PointPair(Draw& draw)> pair;
};

std::vector<Family> families_of_points() {
  const auto corners = [](const BoxShape<3, double>& box) {
    return testing::box_corners(box.centre_m, box.axes, box.half_extents_m);
  };
  std::vector<Family> families;
  for (const int family : {0, 1, 2, 3, 4, 5, 7}) {
    families.push_back({testing::name_of_box_family(family), [=](Draw& draw) {
                          const AlignedBoxes pair = testing::box_pair(family, draw);
                          return testing::PointPair{corners(pair.a), corners(pair.b)};
                        }});
  }
  families.push_back({"hulls of many points in one plane", [](Draw& draw) {
                        const AlignedBoxes pair = testing::box_pair(2, draw);
                        return testing::PointPair{testing::crowded_box(pair.a), testing::crowded_box(pair.b)};
                      }});
  for (const double half_length : {0.0, 0.3}) {
    families.push_back(
        {half_length > 0.0 ? "a core along an axis of a box" : "a point in a box", [=](Draw& draw) {
           const BoxShape<3, double> box{draw.in_cube(), draw.rotation(), {0.8, 0.5, 0.3}};
           const glm::dvec3 at = box.centre_m + box.axes * (glm::dvec3(0.7, 0.45, 0.28) * draw.in_cube());
           const glm::dvec3 way = half_length * box.axes[0];
           return testing::PointPair{corners(box),
                                     half_length > 0.0 ? Points{at - way, at + way} : Points{at}};
         }});
  }
  return families;
}

/// Corners as the shapes themselves compute them would be rounded otherwise: both get the same points.
void agrees_with_the_hull(int pairs) {
  for (const Family& family : families_of_points()) {
    Draw draw(100);
    double worst_m = 0.0;
    int checked = 0;
    // The hulls of many points take long.
    const bool has_many_points = family.pair(draw).a.size() > 8;
    for (int n = 0; n < (has_many_points ? pairs / 10 : pairs); ++n) {
      const auto [a, b] = family.pair(draw);
      const ShapeDistance<3, double> told =
          shape_distance(ConvexVertices<3, double>{a}, ConvexVertices<3, double>{b});
      if (told.distance_m > 0.0) continue;  // which the closed forms have judged
      worst_m = std::max(worst_m, std::abs(-told.distance_m - exact_depth(a, b)));
      // The depth told separates: B, moved along the way told, no longer overlaps.
      double least = std::numeric_limits<double>::max(), most = -least;
      for (const glm::dvec3& point : a) most = std::max(most, glm::dot(told.normal, point));
      for (const glm::dvec3& point : b) least = std::min(least, glm::dot(told.normal, point));
      EXPECT_LE(most - least, -told.distance_m + 1e-12) << family.name << ", pair " << n;
      ++checked;
    }
    EXPECT_LE(worst_m, kAllowedM<double>) << family.name;
    EXPECT_GT(checked, pairs / 20) << family.name;
    ::testing::Test::RecordProperty(std::string("worst_m_of_") + family.name, fmt::format("{:.1e}", worst_m));
  }
}

TEST(GjkDepth, AgreesWithExactHulls) {
  agrees_with_the_hull(kExactPairs);
}
TEST(GjkDepthLongTest, AgreesWithExactHulls) {
  agrees_with_the_hull(kManyExactPairs);
}

}  // namespace
}  // namespace prairie
