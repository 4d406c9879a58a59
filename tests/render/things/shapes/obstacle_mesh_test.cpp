// What is drawn of trunks, blocks and rocks is in plan what walkers avoid, is closed above the ground, faces
// outwards, and leaves no gap on a slope.
#include "render/things/shapes/obstacle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "agents/footprint.h"
#include "tests/render/things/shapes/mesh_check.h"

namespace prairie {
namespace {

constexpr double kSameM = 1e-4;

ObstacleMesh mesh_of(const Obstacle& obstacle, const HeightField& ground) {
  ObstacleMesh mesh;
  add_mesh(obstacle, ground, mesh);
  return mesh;
}

/// How far the farthest corner reaches beyond an obstacle's footprint; negative where it lies inside.
double farthest_beyond_m(const ObstacleMesh& mesh, const Footprint& footprint) {
  double farthest_m = -std::numeric_limits<double>::infinity();
  for (const ObstacleVertex& vertex : mesh.vertices)
    farthest_m = std::max(farthest_m, plan_distance({glm::dvec2(vertex.place_m), 0.0}, footprint).distance_m);
  return farthest_m;
}

/// Of the mesh seen from above, how far its farthest corner lies in a direction.
double support_m(const ObstacleMesh& mesh, glm::dvec2 direction) {
  double farthest_m = -std::numeric_limits<double>::infinity();
  for (const ObstacleVertex& vertex : mesh.vertices)
    farthest_m = std::max(farthest_m, glm::dot(glm::dvec2(vertex.place_m), direction));
  return farthest_m;
}

double support_m(const Footprint& footprint, glm::dvec2 direction) {
  if (const auto* disc = std::get_if<Disc>(&footprint))
    return glm::dot(disc->centre_m, direction) + disc->radius_m;
  double farthest_m = -std::numeric_limits<double>::infinity();
  for (const glm::dvec2 p : std::get<Outline>(footprint).points_m)
    farthest_m = std::max(farthest_m, glm::dot(p, direction));
  return farthest_m;
}

/// The greatest difference of the two outlines, over directions all around.
double outline_error_m(const Obstacle& obstacle, const HeightField& ground) {
  const ObstacleMesh mesh = mesh_of(obstacle, ground);
  const Footprint footprint = footprint_of(obstacle, ground);
  double error_m = 0.0;
  for (int n = 0; n < 720; ++n) {
    const double angle = n * 0.0087266462599716;
    const glm::dvec2 direction(std::cos(angle), std::sin(angle));
    error_m = std::max(error_m, std::abs(support_m(mesh, direction) - support_m(footprint, direction)));
  }
  return error_m;
}

std::vector<Obstacle> some_of_all() {
  std::vector<Obstacle> obstacles;
  for (const double size : {0.05, 0.4, 3.0}) {
    for (const glm::dvec2 place_m : {glm::dvec2(11.3, 17.9), glm::dvec2(20.0, 8.0)}) {
      obstacles.push_back(Trunk{place_m, 0.5 * size, 3.0 * size});
      obstacles.push_back(Block{place_m, {size, 1.7 * size, 0.8 * size}, 0.7});
      obstacles.push_back(Rock{place_m, {1.5 * size, size, 0.9 * size}, 2.1, 7});
    }
  }
  obstacles.push_back(Trunk{{15.0, 15.0}, 5.0, 1.0});
  obstacles.push_back(Block{{15.0, 15.0}, {20.0, 0.02, 9.0}, -0.3});
  return obstacles;
}

TEST(ObstacleMesh, OutlineIsTheFootprint) {
  const HeightField ground = rolling_ground();
  double sagitta_m = 0.0, error_m = 0.0;
  for (const Obstacle& obstacle : some_of_all()) {
    double& worst_m = std::holds_alternative<Trunk>(obstacle) ? sagitta_m : error_m;
    worst_m = std::max(worst_m, outline_error_m(obstacle, ground));
    EXPECT_LT(farthest_beyond_m(mesh_of(obstacle, ground), footprint_of(obstacle, ground)), kSameM);
  }
  std::printf("outlines: blocks and rocks %.1e m, trunks %.1e m\n", error_m, sagitta_m);
  EXPECT_LT(error_m, kSameM);
  EXPECT_LE(sagitta_m, kTrunkSagittaM);
}

TEST(ObstacleMesh, RockIsItsHull) {
  const HeightField ground = rolling_ground();
  const Rock rock{{12.0, 9.0}, {2.0, 1.4, 1.1}, 0.6, 5};
  const RockFrame frame = placed(rock, ground);
  const ConvexHull hull = hull_of(rock);
  const ObstacleMesh mesh = mesh_of(rock, ground);
  ASSERT_EQ(mesh.triangles.size(), hull.triangles.size());
  for (std::size_t n = 0; n < hull.triangles.size(); ++n) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 there_m = frame.origin_m + frame.axes * hull.vertices_m[hull.triangles[n][corner]];
      EXPECT_LT(glm::distance(mesh.vertices[mesh.triangles[n][corner]].place_m, there_m), 1e-12);
    }
  }
}

TEST(ObstacleMesh, IsClosedAboveTheGround) {
  const HeightField ground = rolling_ground();
  for (const Obstacle& obstacle : some_of_all()) {
    const OpenEdges open = open_edges(mesh_of(obstacle, ground));
    EXPECT_LT(open.highest_above_ground_m, -0.25);
    EXPECT_TRUE(open.count == 0 || std::holds_alternative<Trunk>(obstacle));
  }
}

TEST(ObstacleMesh, FacesOutwards) {
  const HeightField ground = rolling_ground();
  for (const Obstacle& obstacle : some_of_all()) {
    const ObstacleMesh mesh = mesh_of(obstacle, ground);
    glm::dvec3 inside_m(0.0);
    for (const ObstacleVertex& vertex : mesh.vertices) {
      inside_m += vertex.place_m / static_cast<double>(mesh.vertices.size());
      EXPECT_NEAR(glm::length(vertex.facing), 1.0f, 1e-5f);
      EXPECT_NEAR(glm::length(vertex.along), 1.0f, 1e-5f);
      EXPECT_NEAR(glm::dot(vertex.facing, vertex.along), 0.0f, 1e-5f);
    }
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
      const glm::dvec3 a = mesh.vertices[triangle[0]].place_m, b = mesh.vertices[triangle[1]].place_m,
                       c = mesh.vertices[triangle[2]].place_m;
      const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
      EXPECT_GT(glm::dot(normal, a - inside_m), 0.0);
      for (const std::uint32_t corner : triangle)
        EXPECT_GT(glm::dot(normal, glm::dvec3(mesh.vertices[corner].facing)), 0.4);
    }
  }
}

TEST(ObstacleMesh, StandsInTheGround) {
  const HeightField ground = rolling_ground();
  for (const Obstacle& obstacle : some_of_all()) {
    if (std::holds_alternative<Rock>(obstacle)) continue;  // exactly its hull, a third of it in the ground
    const ObstacleMesh mesh = mesh_of(obstacle, ground);
    double lowest_m = std::numeric_limits<double>::infinity();
    for (const ObstacleVertex& vertex : mesh.vertices) lowest_m = std::min(lowest_m, vertex.place_m.z);
    for (const ObstacleVertex& vertex : mesh.vertices)
      EXPECT_LT(lowest_m, static_cast<double>(ground.height_m(glm::dvec2(vertex.place_m))));
  }
}

}  // namespace
}  // namespace prairie
