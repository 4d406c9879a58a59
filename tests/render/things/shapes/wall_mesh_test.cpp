// Walls stand where walkers cannot go, right up to the outline, as high as they say, and closed.
#include "render/things/shapes/wall_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "agents/footprint.h"
#include "files/error.h"
#include "tests/render/things/shapes/mesh_check.h"

namespace prairie {
namespace {

constexpr double kSameM = 1e-4;

std::vector<glm::dvec2> round_of(glm::dvec2 centre_m, double radius_m, int corners) {
  std::vector<glm::dvec2> ring;
  for (int n = 0; n < corners; ++n) {
    const double angle = 6.283185307179586 * n / corners;
    ring.push_back(centre_m + radius_m * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// An angular area with a round hole, a narrow one and one clockwise.
WallPolygon area() {
  return {{{4.0, 3.0},
           {28.0, 4.0},
           {27.0, 15.0},
           {19.0, 15.5},
           {26.0, 27.0},
           {16.0, 20.0},
           {5.0, 26.0},
           {4.0, 3.0}},
          {round_of({14.0, 11.0}, 2.5, 40),
           {{22.0, 7.0}, {25.0, 7.0}, {25.0, 7.2}, {22.0, 7.2}},
           {{7.0, 15.0}, {7.0, 19.0}, {11.0, 19.0}, {11.0, 15.0}}}};
}

ObstacleMesh mesh_of(const Wall& wall, const HeightField& ground) {
  ObstacleMesh mesh;
  add_mesh(wall, ground, mesh);
  return mesh;
}

double to_segment_m(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const double share = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + share * (b - a));
}

double to_ring_m(glm::dvec2 p, const std::vector<glm::dvec2>& ring) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const glm::dvec2 a = ring[n], b = ring[(n + 1) % ring.size()];
    if (a != b) nearest_m = std::min(nearest_m, to_segment_m(p, a, b));
  }
  return nearest_m;
}

double length_m(const std::vector<glm::dvec2>& ring) {
  double sum_m = 0.0;
  for (std::size_t n = 0; n < ring.size(); ++n) sum_m += glm::distance(ring[n], ring[(n + 1) % ring.size()]);
  return sum_m;
}

std::vector<std::vector<glm::dvec2>> rings_of(const WallPolygon& polygon) {
  std::vector<std::vector<glm::dvec2>> rings = polygon.holes_m;
  rings.push_back(polygon.outer_m);
  return rings;
}

/// How far a place is from where walkers must not be; negative inside of that.
double to_wall_m(glm::dvec2 p, const std::vector<Footprint>& footprints) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Footprint& footprint : footprints)
    nearest_m = std::min(nearest_m, plan_distance({p, 0.0}, footprint).distance_m);
  return nearest_m;
}

bool is_side(const ObstacleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return std::abs(mesh.vertices[triangle[0]].facing.z) < 0.01f;
}

class WallMesh : public testing::TestWithParam<WallSide> {
 protected:
  HeightField ground_ = rolling_ground();
  Wall wall_{area(), GetParam(), 1.2};
};

TEST_P(WallMesh, OutlineIsWhereWalkersMustNotBe) {
  const ObstacleMesh mesh = mesh_of(wall_, ground_);
  const std::vector<Footprint> footprints = footprints_of(wall_);
  for (const ObstacleVertex& vertex : mesh.vertices)
    EXPECT_LT(to_wall_m(glm::dvec2(vertex.place_m), footprints), kSameM);
  // The sides that stand on the rings go all around them, and look at where walkers are.
  for (const std::vector<glm::dvec2>& ring : rings_of(wall_.outline)) {
    double covered_m = 0.0;
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
      const ObstacleVertex &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                           &c = mesh.vertices[triangle[2]];
      const glm::dvec2 from_m(a.place_m);
      const glm::dvec2 to_m(glm::dvec2(c.place_m) == from_m ? b.place_m : c.place_m);
      if (!is_side(mesh, triangle) || to_ring_m(from_m, ring) > kSameM || to_ring_m(to_m, ring) > kSameM ||
          to_ring_m(0.5 * (from_m + to_m), ring) > kSameM)
        continue;
      covered_m += 0.5 * glm::distance(from_m, to_m);  // each side is of two triangles
      if (glm::distance(from_m, to_m) > 0.05) {
        const glm::dvec2 middle_m = 0.5 * (from_m + to_m), outward(b.facing);
        EXPECT_GT(to_wall_m(middle_m + 0.01 * outward, footprints), 0.0);
        EXPECT_LT(to_wall_m(middle_m - 0.01 * outward, footprints), 1e-9);
      }
    }
    EXPECT_NEAR(covered_m, length_m(ring), 1e-3);
  }
}

TEST_P(WallMesh, IsClosedAboveTheGround) {
  const OpenEdges open = open_edges(mesh_of(wall_, ground_));
  EXPECT_GT(open.count, 0u);  // in the ground
  EXPECT_LT(open.highest_above_ground_m, -0.25);
}

TEST_P(WallMesh, FollowsTheGround) {
  for (const ObstacleVertex& vertex : mesh_of(wall_, ground_).vertices) {
    const auto ground_m = static_cast<double>(ground_.height_m(glm::dvec2(vertex.place_m)));
    const double above_m = vertex.place_m.z - ground_m;
    EXPECT_TRUE(std::abs(above_m - 1.2) < 1e-6 || std::abs(above_m + kIntoGroundM) < 1e-6) << above_m;
    EXPECT_NEAR(above_m, static_cast<double>(vertex.above_ground_m), 1e-5);
  }
}

TEST_P(WallMesh, FacesOutwards) {
  const ObstacleMesh mesh = mesh_of(wall_, ground_);
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    const glm::dvec3 a = mesh.vertices[triangle[0]].place_m, b = mesh.vertices[triangle[1]].place_m,
                     c = mesh.vertices[triangle[2]].place_m;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (glm::length(normal) < 1e-6) continue;
    for (const std::uint32_t corner : triangle)
      EXPECT_GT(glm::dot(glm::normalize(normal), glm::dvec3(mesh.vertices[corner].facing)), 0.9);
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, WallMesh, testing::Values(WallSide::kInside, WallSide::kOutside));

TEST(WallMeshOfAnArea, IsThin) {
  const Wall wall{area(), WallSide::kInside, 1.0};
  const std::vector<std::vector<glm::dvec2>> rings = rings_of(wall.outline);
  double farthest_m = 0.0;
  for (const ObstacleVertex& vertex : mesh_of(wall, rolling_ground()).vertices) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const std::vector<glm::dvec2>& ring : rings)
      nearest_m = std::min(nearest_m, to_ring_m(glm::dvec2(vertex.place_m), ring));
    farthest_m = std::max(farthest_m, nearest_m);
  }
  EXPECT_GT(farthest_m, kWallThicknessM - 1e-9);
  EXPECT_LT(farthest_m, 3.0 * kWallThicknessM + 1e-9);  // at the sharpest corner
}

TEST(WallMeshOfAnArea, IsThinnerWhereThereIsNoRoom) {
  // Two rooms with 0.2 m between them.
  const Wall wall{
      {{{0, 0}, {9, 0}, {9, 9}, {5, 9}, {5, 2}, {4.8, 2}, {4.8, 9}, {0, 9}}, {}}, WallSide::kInside, 1.0};
  const std::vector<Footprint> footprints = footprints_of(wall);
  const ObstacleMesh mesh = mesh_of(wall, HeightField());
  EXPECT_FALSE(mesh.triangles.empty());
  for (const ObstacleVertex& vertex : mesh.vertices)
    EXPECT_LT(to_wall_m(glm::dvec2(vertex.place_m), footprints), kSameM);
}

TEST(WallMeshOfAnArea, LongWallsAreOfFewTriangles) {
  const Wall round{{round_of({0.0, 0.0}, 2000.0, 500), {}}, WallSide::kInside, 1.0};
  EXPECT_LT(mesh_of(round, HeightField()).triangles.size(), 60'000u);
  const Wall solid{{round_of({0.0, 0.0}, 2000.0, 500), {}}, WallSide::kOutside, 1.0};
  EXPECT_LT(mesh_of(solid, HeightField()).triangles.size(), 30'000u);
}

TEST(WallMeshOfNothing, IsEmpty) {
  EXPECT_TRUE(mesh_of({area(), WallSide::kInside, 0.0}, HeightField()).triangles.empty());
  EXPECT_TRUE(mesh_of({area(), WallSide::kOutside, 0.0}, HeightField()).triangles.empty());
}

TEST(WallMeshOfNothing, CrossedOutlinesAreRefused) {
  for (const WallSide side : {WallSide::kInside, WallSide::kOutside}) {
    const Wall crossed{{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}, side, 1.0};
    EXPECT_THROW(mesh_of(crossed, HeightField()), BadInput);
  }
}

}  // namespace
}  // namespace prairie
