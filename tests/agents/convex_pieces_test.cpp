#include "agents/convex_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "agents/gjk.h"
#include "files/error.h"
#include "tests/agents/convex_cases.h"

namespace prairie {
namespace {

using testing::Draw;
using Ring = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t n = 1; n + 1 < ring.size(); ++n) twice += cross(ring[n] - ring[0], ring[n + 1] - ring[0]);
  return 0.5 * twice;
}

/// A star-shaped ring whose corners go in and out.
Ring star(Draw& draw, glm::dvec2 centre, double radius, int corners) {
  Ring ring;
  for (int n = 0; n < corners; ++n) {
    const double angle = 2.0 * std::numbers::pi * (n + 0.8 * draw.unit()) / corners;
    ring.push_back(centre + radius * draw.within(0.4, 1.0) * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

void is_cut_rightly(const WallPolygon& polygon) {
  const std::vector<Ring> pieces = convex_pieces(polygon);
  double area = std::abs(signed_area(polygon.outer_m)), sum = 0.0;
  for (const Ring& hole : polygon.holes_m) area -= std::abs(signed_area(hole));
  std::size_t corners = polygon.outer_m.size();
  for (const Ring& hole : polygon.holes_m) corners += hole.size() + 2;
  EXPECT_LE(pieces.size(), corners - 2);
  for (const Ring& piece : pieces) {
    ASSERT_GE(piece.size(), 3U);
    sum += signed_area(piece);
    for (std::size_t n = 0; n < piece.size(); ++n) {
      const glm::dvec2 at = piece[(n + 1) % piece.size()];
      EXPECT_GT(cross(at - piece[n], piece[(n + 2) % piece.size()] - at), 0.0);
      bool is_given = std::ranges::find(polygon.outer_m, at) != polygon.outer_m.end();
      for (const Ring& hole : polygon.holes_m)
        is_given = is_given || std::ranges::find(hole, at) != hole.end();
      EXPECT_TRUE(is_given);
    }
  }
  EXPECT_NEAR(sum, area, 1e-12 * area);
  // Two pieces touch at most: overlapping by less than rounding is none.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ShapeDistance<2, double> found =
          shape_distance(ConvexVertices<2, double>{pieces[i]}, ConvexVertices<2, double>{pieces[j]});
      EXPECT_GT(found.distance_m, -1e-12);
    }
  }
}

TEST(ConvexPieces, FillThePolygonAndDoNotOverlap) {
  Draw draw(1);
  for (int n = 0; n < 200; ++n) {
    WallPolygon polygon{star(draw, {0.0, 0.0}, 10.0, 5 + draw.below(40)), {}};
    for (int hole = draw.below(4); hole > 0; --hole)
      polygon.holes_m.push_back(
          star(draw, 2.0 * glm::dvec2(std::cos(2.0 * hole), std::sin(2.0 * hole)), 0.9, 3 + draw.below(9)));
    if (draw.below(2) == 0) std::ranges::reverse(polygon.outer_m);
    for (Ring& hole : polygon.holes_m) {
      if (draw.below(2) == 0) std::ranges::reverse(hole);
    }
    SCOPED_TRACE(n);
    is_cut_rightly(polygon);
  }
}

TEST(ConvexPieces, LeaveConvexPolygonsWhole) {
  const Ring square = {{0.0, 0.0}, {0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 0.0}};
  const std::vector<Ring> pieces = convex_pieces({square, {}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 4U);
}

TEST(ConvexPieces, CutRoomsOutOfWalls) {
  const Ring outer = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 6.0}, {0.0, 6.0}};
  const Ring left = {{0.5, 0.5}, {5.0, 0.5}, {5.0, 5.5}, {0.5, 5.5}};
  const Ring right = {{5.0, 5.5}, {6.0, 0.5}, {9.5, 0.5}, {9.5, 5.5}};  // touches the other at a corner
  is_cut_rightly({outer, {left}});
  is_cut_rightly({outer, {left, right}});
  is_cut_rightly({outer, {{{0.0, 3.0}, {1.0, 2.0}, {1.0, 4.0}}}});  // touches a side
}

std::string found_in(const WallPolygon& polygon) {
  try {
    convex_pieces(polygon);
  } catch (const BadInput& fault) {
    return fault.field + ": " + fault.found;
  }
  return "";
}

TEST(ConvexPieces, SayWhatIsWrongWithAPolygon) {
  const Ring square = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}};
  const auto shifted = [](Ring ring, glm::dvec2 way, double scale) {
    for (glm::dvec2& point : ring) point = scale * point + way;
    return ring;
  };
  EXPECT_EQ(found_in({{}, {}}), "outer: 0 different points");
  EXPECT_EQ(found_in({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}}, {}}), "outer: 2 different points");
  EXPECT_EQ(found_in({{{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}}, {}}),
            "outer: points on one line, which have no area");
  EXPECT_EQ(found_in({{{0.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 2.0}}, {}}),
            "outer: a ring that crosses or touches itself");
  EXPECT_EQ(found_in({{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, {}}),
            "outer: a ring that crosses or touches itself");
  EXPECT_EQ(found_in({{{0.0, 0.0}, {1.0, 0.0}, {0.0, std::numeric_limits<double>::infinity()}}, {}}),
            "outer[2]: (0, inf)");
  EXPECT_EQ(found_in({square, {shifted(square, {9.0, 0.0}, 0.5)}}),
            "holes[0]: (9, 0) outside of the outer ring");
  EXPECT_EQ(found_in({square, {shifted(square, {3.0, 1.0}, 0.5)}}),
            "holes[0]: (5, 1) outside of the outer ring");
  const Ring notched = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {2.0, 1.0}, {0.0, 4.0}};
  EXPECT_EQ(found_in({notched, {{{0.5, 2.5}, {0.5, 0.5}, {3.5, 2.5}}}}),
            "holes[0]: a hole that crosses another ring");
  EXPECT_EQ(found_in({square, {shifted(square, {1.0, 1.0}, 0.25), shifted(square, {1.5, 1.5}, 0.25)}}),
            "holes[1]: a hole that crosses another ring");
  for (const Ring& hole : {shifted(square, {1.25, 1.25}, 0.125), shifted(square, {1.0, 1.0}, 0.25)})
    EXPECT_TRUE(found_in({square, {shifted(square, {1.0, 1.0}, 0.25), hole}}).starts_with("holes"))
        << hole[0].x;
  EXPECT_TRUE(found_in({square, {square}}).starts_with("holes"));
  EXPECT_TRUE(found_in({square, {shifted(square, {0.0, 1.0}, 0.25)}}).starts_with("holes"));  // along a side
  EXPECT_EQ(found_in({Ring(kMostPolygonPoints + 1), {}}), "polygon: 10001 points");
}

}  // namespace
}  // namespace prairie
