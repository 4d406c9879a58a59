// The figure is closed, faces outwards and is carried by the skeleton.
#include "render/things/shapes/walker_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "agents/skeleton.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

glm::dvec3 place_of(const WalkerMesh& mesh, std::size_t index) {
  return glm::dvec3(mesh.vertices[mesh.indices[index]].place_m);
}

TEST(WalkerMesh, LevelsHaveFewerTriangles) {
  constexpr std::array<std::size_t, kWalkerLevels> kMost{8000, 1400, 330};
  for (std::size_t level = 0; level < kWalkerLevels; ++level) {
    const std::size_t triangles = walker_mesh(level).indices.size() / 3;
    EXPECT_LE(triangles, kMost[level]);
    EXPECT_GE(triangles, kMost[level] / 2);
  }
}

TEST(WalkerMesh, EveryEdgeHasATriangleOnEitherSide) {
  for (std::size_t level = 0; level < kWalkerLevels; ++level) {
    const WalkerMesh mesh = walker_mesh(level);
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        ++edges[{mesh.indices[n + corner], mesh.indices[n + (corner + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << "level " << level;
    }
  }
}

TEST(WalkerMesh, FacesOutwards) {
  for (std::size_t level = 0; level < kWalkerLevels; ++level) {
    const WalkerMesh mesh = walker_mesh(level);
    double volume = 0.0;
    std::size_t against = 0;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
      const glm::dvec3 a = place_of(mesh, n), b = place_of(mesh, n + 1), c = place_of(mesh, n + 2);
      volume += glm::dot(a, glm::cross(b, c)) / 6.0;
      glm::dvec3 facing(0.0);
      for (std::size_t corner = 0; corner < 3; ++corner)
        facing += glm::dvec3(mesh.vertices[mesh.indices[n + corner]].facing);
      against += glm::dot(glm::cross(b - a, c - a), facing) < 0.0;
    }
    // Of somebody of 75 kg, and where parts reach into one another counted twice.
    EXPECT_GT(volume, 0.055) << level;
    EXPECT_LT(volume, 0.11) << level;
    EXPECT_LT(against, mesh.indices.size() / 3 / 50) << level;
  }
}

TEST(WalkerMesh, IsAsTallAsTheFigureAndMirrored) {
  const WalkerMesh mesh = walker_mesh(0);
  float lowest = 1.0f, highest = 0.0f, left = 0.0f, right = 0.0f;
  for (const WalkerVertex& vertex : mesh.vertices) {
    lowest = std::min(lowest, vertex.place_m.z);
    highest = std::max(highest, vertex.place_m.z);
    left = std::max(left, vertex.place_m.y);
    right = std::min(right, vertex.place_m.y);
    EXPECT_NEAR(glm::length(vertex.facing), 1.0f, 1e-5f);
    EXPECT_LT(vertex.skinning[0], kJointCount);
    EXPECT_LT(vertex.skinning[1], kJointCount);
    EXPECT_LE(vertex.skinning[3], layouts::kWalkerHead);
    EXPECT_GT(vertex.openness, 0.0f);
    EXPECT_LE(vertex.openness, 1.0f);
  }
  EXPECT_NEAR(lowest, 0.0f, 0.006f);
  EXPECT_NEAR(highest, static_cast<float>(kFigureHeightM), 0.02f);
  EXPECT_NEAR(left, -right, 1e-6f);
}

/// A vertex goes with bones that it is near.
TEST(WalkerMesh, BonesCarryWhatIsAroundThem) {
  for (const WalkerVertex& vertex : walker_mesh(0).vertices) {
    for (const std::size_t n : {0u, 1u}) {
      const double weight = n == 0 ? 255.0 - vertex.skinning[2] : vertex.skinning[2];
      if (weight == 0.0) continue;
      const glm::dvec3 joint_m = kRestSkeleton[vertex.skinning[n]].place_m;
      EXPECT_LT(glm::distance(joint_m, glm::dvec3(vertex.place_m)), 0.56);
      if (std::abs(vertex.place_m.y) > 0.02f && std::abs(joint_m.y) > 0.01) {
        EXPECT_GT(joint_m.y * static_cast<double>(vertex.place_m.y), 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace prairie
