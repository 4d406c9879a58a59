// What stands in the meadow (agents/obstacle.h) as triangles in the scene, so that what is drawn is what
// walkers see: in plan a block has its four corners, a rock is the hull that hull_of() finds, a trunk a
// polygon within its circle, off by a millimetre at most. Everything reaches into the ground, so that no gap
// shows on slopes; where it does, it is open at the bottom.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "agents/obstacle.h"
#include "render/things/shapes/obstacle_material.h"

namespace prairie {

struct ObstacleVertex {
  glm::dvec3 place_m{0.0};
  glm::vec3 facing{0.0f};  // unit normal
  glm::vec3 along{0.0f};   // unit, across the normal: where the texture's first coordinate grows
  glm::vec2 on_map{0.0f};  // 1: the texture repeats
  glm::vec3 tint{1.0f};    // 0…2, times the texture's albedo
  float above_ground_m = 0.0f;
  ObstacleMaterial material = ObstacleMaterial::kGranite;
};

struct ObstacleMesh {
  std::vector<ObstacleVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

/// How far a trunk's outline may lie within its circle: by itself, and where pixels are as large as twice
/// that.
inline constexpr double kTrunkSagittaM = 1e-3;
inline constexpr double kFarTrunkSagittaM = 1e-2;

/// Appends.
void add_mesh(const Obstacle& obstacle, const HeightField& ground, ObstacleMesh& mesh,
              double trunk_sagitta_m = kTrunkSagittaM);

/// What has no depth of its own in the ground reaches so far into it.
inline constexpr double kIntoGroundM = 0.3;

}  // namespace prairie
