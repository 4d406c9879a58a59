// Distances of boxes, with the points where they are nearest, against Debian's FCL, if it was there when this
// was built. Its solvers are asked directly, which is faster than by fcl::distance and its tables; both solve
// any pair from cold, and GST_INDEP starts moving pairs from the guess that it left, as a user can make it
// do. GST_LIBCCD keeps no guess.
#include "agents/gjk.h"

#ifdef PRAIRIE_HAS_FCL
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#endif

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bench/benches.h"
#include "bench/timing.h"

namespace prairie {
namespace {

constexpr std::size_t kPairs = 2000;
constexpr int kRounds = 41;
constexpr double kSpeedMPerStep = 0.02;  // a walker's, at 60 steps a second
constexpr double kTurnRadPerStep = 0.01;
constexpr double kLeastDistanceM = 0.01;  // none overlap, whose depth FCL does not tell with these calls

struct BoxPair {
  BoxShape<3, double> a, b;
};

/// A low-discrepancy draw in [0, 1): the n-th multiple of a root.
double draw(std::uint64_t n, double root) {
  return std::fmod(static_cast<double>(n + 1) * root, 1.0);
}

BoxShape<3, double> random_box(std::uint64_t n) {
  const auto symmetric = [&](double root) { return 2.0 * draw(n, std::sqrt(root)) - 1.0; };
  BoxShape<3, double> box;
  box.centre_m = 5.0 * glm::dvec3(symmetric(2.0), symmetric(3.0), symmetric(5.0));
  box.half_extents_m = 0.6 + 0.4 * glm::dvec3(symmetric(7.0), symmetric(11.0), symmetric(13.0));
  const glm::dvec3 x = glm::normalize(glm::dvec3(symmetric(17.0), symmetric(19.0), symmetric(23.0)) + 0.01);
  const glm::dvec3 y =
      glm::normalize(glm::cross(x, glm::dvec3(symmetric(29.0), symmetric(31.0), symmetric(37.0)) + 0.02));
  box.axes = glm::dmat3(x, y, glm::cross(x, y));
  return box;
}

std::vector<BoxPair> separate_pairs() {
  std::vector<BoxPair> pairs;
  for (std::uint64_t n = 0; pairs.size() < kPairs; ++n) {
    const BoxPair pair{random_box(2 * n), random_box(2 * n + 1)};
    if (shape_distance(pair.a, pair.b).distance_m > kLeastDistanceM) pairs.push_back(pair);
  }
  return pairs;
}

/// To and fro, around its vertical axis and along it, so that pairs stay about as far apart as they were.
void move_slowly(std::vector<BoxPair>& pairs, int round) {
  const double sign = round % 20 < 10 ? 1.0 : -1.0;
  const double cosine = std::cos(kTurnRadPerStep), sine = sign * std::sin(kTurnRadPerStep);
  const glm::dmat3 turn(cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0);
  for (BoxPair& pair : pairs) {
    pair.b.centre_m += sign * kSpeedMPerStep * pair.a.axes[0];
    pair.b.axes = turn * pair.b.axes;
  }
}

double own_ms(const std::vector<BoxPair>& pairs, std::vector<GjkCache>* caches, double& sum) {
  return elapsed_ms([&] {
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      GjkCache cold;
      const ShapeDistance<3, double> found =
          shape_distance(pairs[n].a, pairs[n].b, caches == nullptr ? cold : (*caches)[n]);
      sum += found.distance_m + found.point_on_a_m.x + found.point_on_b_m.x;
    }
  });
}

#ifdef PRAIRIE_HAS_FCL
struct FclPair {
  fcl::Boxd a, b;
  fcl::Transform3d place_a, place_b;
  fcl::Vector3d guess{1.0, 0.0, 0.0};
};

fcl::Transform3d fcl_place(const BoxShape<3, double>& box) {
  fcl::Transform3d place = fcl::Transform3d::Identity();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) place.linear()(row, column) = box.axes[column][row];
    place.translation()[column] = box.centre_m[column];
  }
  return place;
}

std::vector<FclPair> fcl_pairs(const std::vector<BoxPair>& pairs) {
  const auto shape = [](const glm::dvec3& half_m) {
    return fcl::Boxd(2.0 * half_m.x, 2.0 * half_m.y, 2.0 * half_m.z);
  };
  std::vector<FclPair> converted;
  for (const BoxPair& pair : pairs)
    converted.push_back(
        {shape(pair.a.half_extents_m), shape(pair.b.half_extents_m), fcl_place(pair.a), fcl_place(pair.b)});
  return converted;
}

template <typename Solver>
double fcl_ms(std::vector<FclPair>& pairs, bool is_warm, double& sum) {
  Solver solver;
  return elapsed_ms([&] {
    for (FclPair& pair : pairs) {
      if (is_warm) {
        solver.enableCachedGuess(true);
        solver.setCachedGuess(pair.guess);
      }
      double distance_m = 0.0;
      fcl::Vector3d on_a, on_b;
      solver.shapeDistance(pair.a, pair.place_a, pair.b, pair.place_b, &distance_m, &on_a, &on_b);
      if (is_warm) pair.guess = solver.getCachedGuess();
      sum += distance_m + on_a[0] + on_b[0];
    }
  });
}
#endif

double pairs_per_s(const std::vector<double>& times_ms) {
  return 1000.0 * static_cast<double>(kPairs) / median(times_ms);
}

}  // namespace

std::vector<Measurement> bench_gjk(const BenchOptions&) {
  const std::vector<BoxPair> pairs = separate_pairs();
  std::vector<BoxPair> moving = pairs;
  std::vector<GjkCache> caches(kPairs);
  std::vector<double> own, own_warm;
  double sum = 0.0;
#ifdef PRAIRIE_HAS_FCL
  std::vector<double> indep, ccd, indep_warm, ccd_moving;
  std::vector<FclPair> of_fcl = fcl_pairs(pairs), moving_of_fcl = of_fcl;
#endif
  for (int round = 0; round < kRounds; ++round) {
    move_slowly(moving, round);
    own.push_back(own_ms(pairs, nullptr, sum));
    own_warm.push_back(own_ms(moving, &caches, sum));
#ifdef PRAIRIE_HAS_FCL
    for (std::size_t n = 0; n < kPairs; ++n) moving_of_fcl[n].place_b = fcl_place(moving[n].b);
    indep.push_back(fcl_ms<fcl::detail::GJKSolver_indepd>(of_fcl, false, sum));
    ccd.push_back(fcl_ms<fcl::detail::GJKSolver_libccdd>(of_fcl, false, sum));
    indep_warm.push_back(fcl_ms<fcl::detail::GJKSolver_indepd>(moving_of_fcl, true, sum));
    ccd_moving.push_back(fcl_ms<fcl::detail::GJKSolver_libccdd>(moving_of_fcl, false, sum));
#endif
  }
  std::vector<Measurement> measurements = {{"gjk.pairs_per_s", pairs_per_s(own)},
                                           {"gjk.warm_pairs_per_s", pairs_per_s(own_warm)}};
  if (!std::isfinite(sum)) measurements[0].note = "a distance that is not finite";
#ifdef PRAIRIE_HAS_FCL
  const double faster = std::max(pairs_per_s(indep), pairs_per_s(ccd));
  const double faster_moving = std::max(pairs_per_s(indep_warm), pairs_per_s(ccd_moving));
  measurements.push_back({"gjk.fcl_pairs_per_s", pairs_per_s(indep)});
  measurements.push_back({"gjk.ccd_pairs_per_s", pairs_per_s(ccd)});
  measurements.push_back({"gjk.ratio", pairs_per_s(own) / faster});
  measurements.push_back({"gjk.warm_ratio", pairs_per_s(own_warm) / faster_moving});
#else
  for (const char* name : {"gjk.fcl_pairs_per_s", "gjk.ccd_pairs_per_s", "gjk.ratio", "gjk.warm_ratio"})
    measurements.push_back({.name = name, .note = "built without FCL"});
#endif
  return measurements;
}

}  // namespace prairie
