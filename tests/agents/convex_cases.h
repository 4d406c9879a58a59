// Pairs of convex shapes, ordinary and degenerate, for tests of distances.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

namespace prairie::testing {

/// The same on every platform, other than std's distributions.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double within(double from, double to) { return from + (to - from) * unit(); }
  int below(int count) { return static_cast<int>(unit() * count); }
  double size(double from, double to) { return std::exp(within(std::log(from), std::log(to))); }
  glm::dvec3 in_cube() { return {within(-1.0, 1.0), within(-1.0, 1.0), within(-1.0, 1.0)}; }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 point = in_cube();
      const double length = glm::length(point);
      if (length > 0.1 && length < 1.0) return point / length;
    }
  }
  glm::dmat3 rotation() {
    const glm::dvec3 x = direction();
    glm::dvec3 other = direction();
    while (std::abs(glm::dot(x, other)) > 0.9) other = direction();
    const glm::dvec3 y = glm::normalize(glm::cross(x, other));
    return {x, y, glm::cross(x, y)};
  }

 private:
  std::mt19937_64 bits_;
};

using Points = std::vector<glm::dvec3>;
struct PointPair {
  Points a, b;
};

enum class ConvexCase {
  kRandom,
  kBoxes,          // corners of turned boxes
  kTouching,       // one corner in common, bit for bit
  kParallelFaces,  // along the axes: some touch, some are 1e-7 apart
  kNeedles,        // 1 : 1e4
  kPlates,
  kCoincident,
  kSmallGap,  // 1e-7 between two that face each other
  kFew,       // points, segments, triangles, some of them repeated
  kUnequal,   // one a thousand times as large
  kCrossedEdges,
  kFlat,  // both in one plane
};
inline constexpr int kConvexCases = 12;

inline Points cloud(Draw& draw, int count, glm::dvec3 size) {
  Points points;
  for (int n = 0; n < count; ++n) points.push_back(draw.in_cube() * size);
  return points;
}
inline Points box_corners(const glm::dvec3& centre, const glm::dmat3& axes, const glm::dvec3& half) {
  Points corners;
  for (int n = 0; n < 8; ++n) {
    const glm::dvec3 sign((n & 1) != 0 ? -1.0 : 1.0, (n & 2) != 0 ? -1.0 : 1.0, (n & 4) != 0 ? -1.0 : 1.0);
    corners.push_back(centre + axes * (sign * half));
  }
  return corners;
}
inline void shift(Points& points, const glm::dmat3& turn, const glm::dvec3& way) {
  for (glm::dvec3& point : points) point = turn * point + way;
}
inline glm::dvec3 dyadic(const glm::dvec3& point) {
  return glm::round(point * 1024.0) / 1024.0;
}

inline int corner_count(Draw& draw) {
  return 4 + draw.below(17);
}

inline PointPair clouds(Draw& draw, glm::dvec3 size) {
  return {cloud(draw, corner_count(draw), size), cloud(draw, corner_count(draw), size)};
}

inline void turn_both(PointPair& pair, const glm::dmat3& turn) {
  shift(pair.a, turn, glm::dvec3(0.0));
  shift(pair.b, turn, glm::dvec3(0.0));
}

inline PointPair touching_pair(Draw& draw) {
  PointPair pair = clouds(draw, glm::dvec3(1.0));
  for (Points* points : {&pair.a, &pair.b}) {
    for (glm::dvec3& point : *points) point = dyadic(point);
  }
  for (glm::dvec3& point : pair.a) point.z = -std::abs(point.z);
  for (glm::dvec3& point : pair.b) point.z = std::abs(point.z);
  pair.a.push_back({0.25, 0.125, 0.0});
  pair.b.push_back({0.25, 0.125, 0.0});
  return pair;
}

inline PointPair parallel_boxes(Draw& draw, double small_gap) {
  const double gaps[] = {0.0, small_gap, 0.5, -0.25};
  const glm::dvec3 half_a = 0.5 * dyadic(draw.in_cube() + 1.2), half_b = 0.5 * dyadic(draw.in_cube() + 1.2);
  glm::dvec3 centre = dyadic(draw.in_cube());
  centre[draw.below(3)] = 0.0;
  const int axis = draw.below(3);
  centre[axis] = half_a[axis] + half_b[axis] + gaps[draw.below(4)];
  return {box_corners({}, glm::dmat3(1.0), half_a), box_corners(centre, glm::dmat3(1.0), half_b)};
}

inline PointPair thin_pair(Draw& draw, glm::dvec3 size) {
  PointPair pair = clouds(draw, size);
  const glm::dmat3 turn = draw.rotation();
  const bool is_parallel = draw.below(3) == 0;
  const double way = draw.size(1e-5, 1.0);
  shift(pair.a, turn, glm::dvec3(0.0));
  shift(pair.b, is_parallel ? turn : draw.rotation(), way * draw.direction());
  return pair;
}

/// Corners, edges or triangles that face one another across the gap.
inline PointPair pair_with_gap(Draw& draw, double small_gap) {
  PointPair pair = clouds(draw, glm::dvec3(1.0));
  const int face_a = 1 + draw.below(3), face_b = 1 + draw.below(3);
  for (std::size_t n = 0; n < pair.a.size(); ++n)
    pair.a[n].z = n < static_cast<std::size_t>(face_a) ? 0.0 : -std::abs(pair.a[n].z);
  for (std::size_t n = 0; n < pair.b.size(); ++n)
    pair.b[n].z = n < static_cast<std::size_t>(face_b) ? small_gap : small_gap + std::abs(pair.b[n].z);
  turn_both(pair, draw.rotation());
  return pair;
}

inline PointPair pair_of_few(Draw& draw) {
  PointPair pair = {cloud(draw, 1 + draw.below(3), glm::dvec3(1.0)),
                    cloud(draw, 1 + draw.below(3), glm::dvec3(1.0))};
  if (draw.below(2) == 0) pair.a.push_back(pair.a[0]);
  if (draw.below(2) == 0) pair.b.push_back(0.5 * (pair.b.front() + pair.b.back()));
  if (draw.below(4) == 0) pair.b.push_back(pair.a[0]);
  return pair;
}

inline PointPair unequal_pair(Draw& draw) {
  PointPair pair = {cloud(draw, corner_count(draw), glm::dvec3(1.0)),
                    cloud(draw, corner_count(draw), glm::dvec3(1e3))};
  shift(pair.b, glm::dmat3(1.0), draw.within(900.0, 1800.0) * draw.direction());
  if (draw.below(2) == 0) std::swap(pair.a, pair.b);
  return pair;
}

inline PointPair crossed_edges(Draw& draw, double small_gap) {
  PointPair pair = {cloud(draw, 4, glm::dvec3(1.0)), cloud(draw, 4, glm::dvec3(1.0))};
  for (glm::dvec3& point : pair.a) point.z = -std::abs(point.z);
  for (glm::dvec3& point : pair.b) point.z = small_gap + std::abs(point.z);
  pair.a[0] = {-1.0, draw.within(-1.0, 1.0), 0.0};
  pair.a[1] = {1.0, draw.within(-1.0, 1.0), 0.0};
  pair.b[0] = {draw.within(-1.0, 1.0), -1.0, small_gap};
  pair.b[1] = {draw.within(-1.0, 1.0), 1.0, small_gap};
  turn_both(pair, draw.rotation());
  return pair;
}

inline PointPair flat_pair(Draw& draw, glm::dvec3 apart) {
  PointPair pair = clouds(draw, glm::dvec3(1.0, 1.0, 0.0));
  const glm::dvec3 way = apart * glm::dvec3(1.0, 1.0, 0.0);
  const glm::dmat3 turn = draw.below(2) == 0 ? draw.rotation() : glm::dmat3(1.0);
  shift(pair.b, glm::dmat3(1.0), way);
  turn_both(pair, turn);
  return pair;
}

/// `size`: of the shapes, roughly; `small_gap`: the one of kSmallGap, absolute.
inline PointPair convex_pair(Draw& draw, ConvexCase kind, double small_gap) {
  const glm::dvec3 apart = draw.size(0.01, 10.0) * draw.direction();
  PointPair pair;
  switch (kind) {
    case ConvexCase::kRandom:
      pair = clouds(draw, glm::dvec3(1.0));
      shift(pair.b, glm::dmat3(1.0), apart);
      return pair;
    case ConvexCase::kBoxes:
      return {box_corners({}, draw.rotation(), 0.5 * (draw.in_cube() + 1.2)),
              box_corners(apart, draw.rotation(), 0.5 * (draw.in_cube() + 1.2))};
    case ConvexCase::kTouching:
      return touching_pair(draw);
    case ConvexCase::kParallelFaces:
      return parallel_boxes(draw, small_gap);
    case ConvexCase::kNeedles:
      return thin_pair(draw, {1.0, 1e-4, 1e-4});
    case ConvexCase::kPlates:
      return thin_pair(draw, {1.0, 1.0, 1e-4});
    case ConvexCase::kCoincident:
      pair.a = cloud(draw, corner_count(draw), glm::dvec3(1.0));
      pair.b = pair.a;
      return pair;
    case ConvexCase::kSmallGap:
      return pair_with_gap(draw, small_gap);
    case ConvexCase::kFew:
      return pair_of_few(draw);
    case ConvexCase::kUnequal:
      return unequal_pair(draw);
    case ConvexCase::kCrossedEdges:
      return crossed_edges(draw, small_gap);
    case ConvexCase::kFlat:
      return flat_pair(draw, apart);
  }
  return pair;
}

}  // namespace prairie::testing
