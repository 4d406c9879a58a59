// Pairs of shapes that lie as made things do – of one turn, on one line, in one plane, in the same place –
// with their distance in closed form; for tests of how deep shapes are in one another.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "agents/convex_shapes.h"
#include "tests/agents/convex_cases.h"

namespace prairie::testing {

/// In A's frame: by how far the boxes' extents miss one another along each axis, negative where they overlap;
/// of boxes of one turn that is all there is to their distance.
template <int D>
double distance_of_extents(const glm::vec<D, double>& between, const glm::vec<D, double>& extents) {
  double deepest = -1e300, outside2 = 0.0;
  for (int axis = 0; axis < D; ++axis) {
    const double gap = std::abs(between[axis]) - extents[axis];
    deepest = std::max(deepest, gap);
    outside2 += gap > 0.0 ? gap * gap : 0.0;
  }
  return deepest > 0.0 ? std::sqrt(outside2) : deepest;
}

/// Two boxes of one turn.
struct AlignedBoxes {
  BoxShape<3, double> a, b;
  double distance_m = 0.0;
};

inline AlignedBoxes aligned_boxes(const glm::dmat3& axes, const glm::dvec3& centre, const glm::dvec3& between,
                                  const glm::dvec3& half_a, const glm::dvec3& half_b) {
  AlignedBoxes pair;
  pair.a = {.centre_m = centre, .axes = axes, .half_extents_m = half_a};
  pair.b = {.centre_m = centre + axes * between, .axes = axes, .half_extents_m = half_b};
  // As the numbers have come out.
  const glm::dvec3 told = glm::transpose(axes) * (pair.b.centre_m - pair.a.centre_m);
  pair.distance_m = distance_of_extents<3>(told, half_a + half_b);
  return pair;
}

inline glm::dmat3 yaw(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
}

/// The families of boxes, by number.
inline constexpr int kBoxFamilies = 8;
inline const char* name_of_box_family(int family) {
  constexpr const char* kNames[kBoxFamilies] = {"cubes of one yaw, moved along an axis",
                                                "cubes of one turn, moved along an axis",
                                                "boxes of one yaw in one place",
                                                "bars of 2 m × 4 cm in a bundle",
                                                "rods of 2 m × 2 mm in one place",
                                                "rods of 2 m × 2 mm, moved along themselves",
                                                "plates in one plane",
                                                "boxes that share the plane of a side"};
  return kNames[family];
}
inline AlignedBoxes box_pair(int family, Draw& draw) {
  const glm::dvec3 centre = draw.in_cube();
  const double slide = draw.within(-1.0, 1.0);
  switch (family) {
    case 0:
      return aligned_boxes(yaw(draw.within(-3.2, 3.2)), centre, {slide, 0, 0}, glm::dvec3(0.5),
                           glm::dvec3(0.5));
    case 1:
      return aligned_boxes(draw.rotation(), centre, {slide, 0, 0}, glm::dvec3(0.5), glm::dvec3(0.5));
    case 2:
      return aligned_boxes(yaw(draw.within(-3.2, 3.2)), centre, glm::dvec3(0.0), {0.5, 0.3, 0.2},
                           {0.5, 0.3, 0.2});
    case 3:
      return aligned_boxes(draw.rotation(), centre,
                           {slide, 0.03 * draw.within(-1, 1), 0.03 * draw.within(-1, 1)}, {1, 0.02, 0.02},
                           {1, 0.02, 0.02});
    case 4:
      return aligned_boxes(draw.rotation(), centre, glm::dvec3(0.0), {1, 0.001, 0.001}, {1, 0.001, 0.001});
    case 5:
      return aligned_boxes(draw.rotation(), centre, {slide, 0, 0}, {1, 0.001, 0.001}, {1, 0.001, 0.001});
    case 6:
      return aligned_boxes(draw.rotation(), centre, {slide, draw.within(-1, 1), 0}, {0.5, 0.4, 0.0},
                           {0.3, 0.6, 0.0});
    default:
      return aligned_boxes(draw.rotation(), centre, {slide, draw.within(-1, 1), 0.2}, {0.5, 0.4, 0.3},
                           {0.6, 0.2, 0.1});
  }
}

/// The corners of a box and the middles of its edges and sides: many points in one plane and on one line.
inline Points crowded_box(const BoxShape<3, double>& box) {
  Points points;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z)
        points.push_back(box.centre_m + box.axes * (glm::dvec3(x, y, z) * box.half_extents_m));
    }
  }
  return points;
}

}  // namespace prairie::testing
