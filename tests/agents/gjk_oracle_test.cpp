// Distances against CGAL's Polytope_distance_d, which solves the quadratic program in exact arithmetic.
#include <CGAL/Gmpzf.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "agents/gjk.h"
#include "tests/agents/convex_cases.h"

namespace prairie {
namespace {

using testing::ConvexCase;
using testing::Draw;
using testing::PointPair;

template <typename Real>
using PointsIn = std::vector<glm::vec<3, Real>>;

using Kernel = CGAL::Homogeneous<CGAL::Gmpzf>;

struct GoesRoundInCircles {};

/// As CGAL's, but gives up after more steps than a pair can need: the solver behind Polytope_distance_d of
/// CGAL 5.5 does not end for one pair in some ten thousand. With doubles as its number type inner products
/// would be rounded, which is seen far from the origin.
struct BoundedTraits : CGAL::Polytope_distance_d_traits_3<Kernel> {
  struct Access_coordinates_begin_d : CGAL::Access_coordinates_begin_3<Kernel> {
    auto operator()(const Kernel::Point_3& point) const {
      if (++reads > 1'000'000) throw GoesRoundInCircles{};
      return CGAL::Access_coordinates_begin_3<Kernel>::operator()(point);
    }
  };
  Access_coordinates_begin_d access_coordinates_begin_d_object() const { return {}; }
  static inline std::int64_t reads = 0;
};

/// The same quadratic program by Bland's rule, which always ends.
double distance_by_blands_rule(const std::vector<Kernel::Point_3>& a, const std::vector<Kernel::Point_3>& b) {
  using Exact = CGAL::Gmpzf;
  CGAL::Quadratic_program<Exact> program(CGAL::EQUAL, true, Exact(0), false, Exact(0));
  std::vector<std::array<Exact, 3>> columns;
  for (const auto& point : a) columns.push_back({point.hx(), point.hy(), point.hz()});
  for (const auto& point : b) columns.push_back({-point.hx(), -point.hy(), -point.hz()});
  for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
    program.set_a(i, i < static_cast<int>(a.size()) ? 0 : 1, Exact(1));
    for (int j = 0; j <= i; ++j) {
      Exact product(0);
      for (int axis = 0; axis < 3; ++axis) product += columns[i][axis] * columns[j][axis];
      program.set_d(i, j, Exact(2) * product);
    }
  }
  program.set_b(0, Exact(1));
  program.set_b(1, Exact(1));
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_nonnegative_quadratic_program(program, Exact(), options);
  return std::sqrt(CGAL::to_double(solution.objective_value()));
}

/// 0 where they overlap.
template <typename Real>
double exact_distance(const PointsIn<Real>& points_a, const PointsIn<Real>& points_b, int& by_blands_rule) {
  const auto converted = [](const PointsIn<Real>& points) {
    std::vector<Kernel::Point_3> of_kernel;
    for (const auto& point : points) of_kernel.emplace_back(point.x, point.y, point.z, 1);
    return of_kernel;
  };
  const auto a = converted(points_a), b = converted(points_b);
  BoundedTraits::reads = 0;
  try {
    const CGAL::Polytope_distance_d<BoundedTraits> found(a.begin(), a.end(), b.begin(), b.end());
    return std::sqrt(CGAL::to_double(found.squared_distance_numerator()) /
                     CGAL::to_double(found.squared_distance_denominator()));
  } catch (const GoesRoundInCircles&) {
    ++by_blands_rule;
    return distance_by_blands_rule(a, b);
  }
}

/// The largest coordinate, after the middle of A has been subtracted.
template <typename Real>
double scale_of(const PointsIn<Real>& a, const PointsIn<Real>& b) {
  glm::dvec3 centre(0.0);
  for (const auto& point : a) centre += glm::dvec3(point) / static_cast<double>(a.size());
  double scale = 0.0;
  for (const PointsIn<Real>* points : {&a, &b}) {
    for (const auto& point : *points)
      scale = std::max(scale, largest_of(glm::abs(glm::dvec3(point) - centre)));
  }
  return scale;
}

/// Every twelfth pair is of one kind; of each kind every fourth is far from the origin, in doubles 10 000 km
/// away.
template <typename Real>
void agrees_with_the_oracle(int pairs, std::uint64_t seed) {
  constexpr bool kIsFloat = std::is_same_v<Real, float>;
  Draw draw(seed);
  double worst = 0.0;
  int by_blands_rule = 0;
  for (int n = 0; n < pairs; ++n) {
    const auto kind = static_cast<ConvexCase>(n % testing::kConvexCases);
    PointPair pair = convex_pair(draw, kind, 1e-7);
    if ((n / testing::kConvexCases) % 4 == 0) {
      const glm::dvec3 way = (kIsFloat ? 1e3 : 1e7) * draw.direction();
      testing::shift(pair.a, glm::dmat3(1.0), way);
      testing::shift(pair.b, glm::dmat3(1.0), way);
    }
    const PointsIn<Real> a(pair.a.begin(), pair.a.end()), b(pair.b.begin(), pair.b.end());
    const ConvexVertices<3, Real> shape_a{a}, shape_b{b};
    const ShapeDistance<3, Real> found = shape_distance(shape_a, shape_b);
    const double distance = std::max(0.0, static_cast<double>(found.distance_m));
    const double exact = exact_distance(a, b, by_blands_rule);
    const double allowed =
        kIsFloat ? 1e-4 * exact + 16 * 0x1p-23 * scale_of(a, b) : 1e-6 * exact + 1e-14 * scale_of(a, b);
    ASSERT_TRUE(std::isfinite(found.distance_m)) << n;
    ASSERT_NEAR(distance, exact, allowed) << "pair " << n << " of kind " << n % testing::kConvexCases << ", "
                                          << found.iterations << " iterations";
    if (allowed > 0.0) worst = std::max(worst, std::abs(distance - exact) / allowed);
  }
  EXPECT_LE(by_blands_rule, pairs / 1000);
  ::testing::Test::RecordProperty("by_blands_rule", by_blands_rule);
  ::testing::Test::RecordProperty("worst_share_of_what_is_allowed", std::to_string(worst));
}

TEST(GjkOracle, AgreesInDouble) {
  agrees_with_the_oracle<double>(10'008, 1);
}
TEST(GjkOracle, AgreesInFloat) {
  agrees_with_the_oracle<float>(10'008, 2);
}
TEST(GjkOracleLongTest, AgreesInDouble) {
  agrees_with_the_oracle<double>(100'008, 3);
}
TEST(GjkOracleLongTest, AgreesInFloat) {
  agrees_with_the_oracle<float>(100'008, 4);
}

}  // namespace
}  // namespace prairie
