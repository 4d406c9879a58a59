#include "render/things/shapes/obstacle_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

/// Numbers in [0, 1) that belong to a place: nothing drawn changes as things are added elsewhere.
class Chance {
 public:
  Chance(glm::dvec2 place_m, std::uint32_t seed) : x_(word(place_m.x)), y_(word(place_m.y)), seed_(seed) {}
  float operator()(std::uint32_t n) const {
    return Kernels{}.unit_from_u32(Kernels{}.hash_uvec3({x_ + n, y_, seed_}).x);
  }

 private:
  static std::uint32_t word(double m) { return static_cast<std::uint32_t>(std::llround(m * 64.0)); }
  std::uint32_t x_, y_, seed_;
};

float above_m(const HeightField& ground, glm::dvec3 place_m) {
  return static_cast<float>(place_m.z - static_cast<double>(ground.height_m(glm::dvec2(place_m))));
}

std::uint32_t next_index(const ObstacleMesh& mesh) {
  return static_cast<std::uint32_t>(mesh.vertices.size());
}

glm::vec3 across(glm::vec3 facing, glm::vec3 along) {
  return glm::normalize(along - facing * glm::dot(facing, along));
}

/// A circle of a trunk, seen from its axis.
struct Ring {
  double radius_m = 0.0, z_m = 0.0;
  double out = 1.0, up = 0.0;  // the normal
  double up_the_bark_m = 0.0;
};

void add_trunk(const Trunk& trunk, const HeightField& ground, double sagitta_m, ObstacleMesh& mesh) {
  const Chance chance(trunk.position_m, 1);
  const double radius_m = trunk.radius_m;
  // The sagitta of a side is r (1 - cos(pi / n)), less than r (pi / n)^2 / 2.
  const auto sides = static_cast<std::uint32_t>(
      std::max(8.0, std::ceil(std::numbers::pi / std::sqrt(2.0 * sagitta_m / radius_m))));
  const auto direction = [&](std::uint32_t n) {
    const double angle = 2.0 * std::numbers::pi * (n % sides) / sides;
    return glm::dvec2(std::cos(angle), std::sin(angle));
  };
  const auto foot_m = static_cast<double>(ground.height_m(trunk.position_m));
  double lowest_m = foot_m;
  for (std::uint32_t n = 0; n < sides; ++n) {
    const glm::dvec2 edge_m = trunk.position_m + radius_m * direction(n);
    lowest_m = std::min(lowest_m, static_cast<double>(ground.height_m(edge_m)));
  }

  // A cylinder with half a sphere upon it; bark on its shoulder, worn wood above.
  const double rise_m = std::min(radius_m, trunk.height_m);
  const double shoulder_m = foot_m + trunk.height_m - rise_m;
  const int arcs = std::clamp(static_cast<int>(sides / 4), 3, 16);
  std::vector<Ring> bark, wood;
  const double lengths = std::clamp(std::ceil((shoulder_m - lowest_m) / 1.5), 1.0, 16.0);
  const double bottom_m = lowest_m - kIntoGroundM;
  for (double n = 0.0; n < lengths; ++n) {
    const double z_m = bottom_m + (shoulder_m - bottom_m) * n / lengths;
    bark.push_back({radius_m, z_m, 1.0, 0.0, z_m - foot_m});
  }
  const int last_of_bark = arcs / 3;
  for (int n = 0; n <= arcs; ++n) {
    const double angle = 0.5 * std::numbers::pi * n / arcs;
    const double out = n == arcs ? 0.0 : std::cos(angle), up = std::sin(angle);
    const glm::dvec2 normal = glm::normalize(glm::dvec2(out * rise_m, up * radius_m));
    const Ring ring{radius_m * out, shoulder_m + rise_m * up, normal.x, normal.y,
                    shoulder_m - foot_m + rise_m * angle};
    if (n <= last_of_bark) bark.push_back(ring);
    if (n >= last_of_bark) wood.push_back(ring);
  }

  const double around = std::max(1.0, std::round(2.0 * std::numbers::pi * radius_m / kBarkM));
  const glm::vec2 shift(chance(1), chance(2));
  const glm::vec3 tone = glm::vec3(0.8f + 0.4f * chance(3)) * glm::vec3(1.0f + 0.1f * chance(4), 1.0f, 1.0f);
  const auto add_rings = [&](const std::vector<Ring>& rings, ObstacleMaterial material) {
    for (std::size_t row = 0; row < rings.size(); ++row) {
      const Ring& ring = rings[row];
      for (std::uint32_t n = 0; n <= sides; ++n) {
        const glm::dvec2 way = direction(n);
        ObstacleVertex vertex;
        vertex.place_m = {trunk.position_m + ring.radius_m * way, ring.z_m};
        vertex.facing = glm::vec3(glm::dvec3(ring.out * way, ring.up));
        vertex.above_ground_m = above_m(ground, vertex.place_m);
        vertex.material = material;
        if (material == ObstacleMaterial::kBark) {
          vertex.along = glm::vec3(-way.y, way.x, 0.0);
          vertex.on_map = shift + glm::vec2(around * n / sides, ring.up_the_bark_m / kBarkM);
          // Algae and moss where it is shaded and damp: in the north, and near the ground.
          const float damp = std::clamp(0.75f * static_cast<float>(way.y) + 0.35f * chance(20 + n / 3 % 8) -
                                            0.25f * vertex.above_ground_m,
                                        0.0f, 1.0f);
          vertex.tint = tone * glm::mix(glm::vec3(1.0f), glm::vec3(0.78f, 1.02f, 0.60f), damp);
        } else {
          vertex.along = across(vertex.facing, {1.0f, 0.0f, 0.0f});
          vertex.on_map = glm::vec2(0.5 + 0.5 * ring.radius_m / radius_m * way);
        }
        mesh.vertices.push_back(vertex);
      }
    }
    const std::uint32_t first = next_index(mesh) - static_cast<std::uint32_t>(rings.size()) * (sides + 1);
    for (std::uint32_t row = 0; row + 1 < rings.size(); ++row) {
      for (std::uint32_t n = 0; n < sides; ++n) {
        const std::uint32_t a = first + row * (sides + 1) + n, b = a + 1, d = a + sides + 1, c = d + 1;
        mesh.triangles.push_back({a, b, c});
        if (rings[row + 1].radius_m > 0.0) mesh.triangles.push_back({a, c, d});
      }
    }
  };
  add_rings(bark, ObstacleMaterial::kBark);
  add_rings(wood, ObstacleMaterial::kEndGrain);
}

/// From one end of a block's side to the other, so that the edges' shading has a strip of its own.
std::vector<double> steps_along(double half_m) {
  constexpr double kEdgeM = 0.006, kLongestStepM = 8.0;
  const double edge_m = std::min(kEdgeM, 0.2 * half_m);
  const double inside_m = half_m - edge_m;
  const double pieces = std::clamp(std::ceil(2.0 * inside_m / kLongestStepM), 1.0, 16.0);
  std::vector<double> steps{-half_m};
  for (double n = 0.0; n <= pieces; ++n) steps.push_back(inside_m * (2.0 * n / pieces - 1.0));
  steps.push_back(half_m);
  return steps;
}

/// The lowest ground along a block's sides.
double lowest_around_m(const PlacedBlock& place, const HeightField& ground) {
  constexpr double kStepM = 0.5, kMostSteps = 256.0;
  const double half_x_m = place.half_size_m.x, half_y_m = place.half_size_m.y;
  const double steps = std::clamp(std::ceil(2.0 * std::max(half_x_m, half_y_m) / kStepM), 1.0, kMostSteps);
  double lowest_m = std::numeric_limits<double>::infinity();
  for (double n = 0.0; n <= steps; ++n) {
    const double share = 2.0 * n / steps - 1.0;
    for (const glm::dvec2 at_m :
         {glm::dvec2(share * half_x_m, -half_y_m), glm::dvec2(share * half_x_m, half_y_m),
          glm::dvec2(-half_x_m, share * half_y_m), glm::dvec2(half_x_m, share * half_y_m)}) {
      const glm::dvec3 place_m = place.centre_m + place.axes * glm::dvec3(at_m, 0.0);
      lowest_m = std::min(lowest_m, static_cast<double>(ground.height_m(glm::dvec2(place_m))));
    }
  }
  return lowest_m;
}

// Its edges are sharp, as walkers see them, and shaded as if they were round.
void add_block(const Block& block, const HeightField& ground, ObstacleMesh& mesh) {
  const Chance chance(block.position_m, 2);
  const PlacedBlock place = placed(block, ground);
  glm::dvec3 half_m = place.half_size_m, centre_m = place.centre_m;
  const double deeper_m =
      std::max(centre_m.z - half_m.z - lowest_around_m(place, ground), 0.0) + kIntoGroundM;
  half_m.z += 0.5 * deeper_m;
  centre_m.z -= 0.5 * deeper_m;
  const float tone = 0.75f + 0.45f * chance(1);
  const glm::vec3 tint =
      tone * glm::mix(glm::vec3(1.12f, 1.0f, 0.86f), glm::vec3(0.96f, 1.0f, 1.0f), chance(2));
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    const std::vector<double> us = steps_along(half_m[u_axis]), vs = steps_along(half_m[v_axis]);
    // Boards lie along the longer side, level on the sides, and each face has as many as fit.
    const int board_axis = axis != 2 ? 1 - axis : (half_m.x >= half_m.y ? 0 : 1);
    const int stack_axis = 3 - axis - board_axis;
    const double boards = std::max(1.0, std::round(2.0 * place.half_size_m[stack_axis] / kBoardM));
    const double first_board =
        std::floor(8.0 * static_cast<double>(chance(10 + static_cast<std::uint32_t>(face))));
    const double shift = static_cast<double>(chance(20 + static_cast<std::uint32_t>(face)));
    glm::dvec3 facing(0.0), along(0.0);
    facing[axis] = side;
    along[board_axis] = 1.0;
    glm::dvec3 stacked = glm::cross(facing, along);
    const std::uint32_t first = next_index(mesh);
    for (const double v : vs) {
      for (const double u : us) {
        glm::dvec3 at_m(0.0), bent(0.0);
        at_m[axis] = side * half_m[axis];
        at_m[u_axis] = u;
        at_m[v_axis] = v;
        bent[axis] = side;
        if (std::abs(u) == half_m[u_axis]) bent[u_axis] = std::copysign(1.0, u);
        if (std::abs(v) == half_m[v_axis]) bent[v_axis] = std::copysign(1.0, v);
        ObstacleVertex vertex;
        vertex.place_m = centre_m + place.axes * at_m;
        vertex.facing = glm::vec3(place.axes * glm::normalize(bent));
        vertex.along = across(vertex.facing, glm::vec3(place.axes * along));
        // Whole boards end at the top; what is in the ground shows nothing.
        const double from_top = glm::dot(at_m, glm::abs(stacked)) - half_m[stack_axis];
        const double board = first_board + from_top * boards / (2.0 * place.half_size_m[stack_axis]);
        const double sense = glm::dot(stacked, glm::dvec3(1.0));
        vertex.on_map =
            glm::vec2(shift + glm::dot(at_m, along) / kBoardLengthM, sense * board / kBoardsOnMap);
        vertex.tint = tint;
        vertex.above_ground_m = above_m(ground, vertex.place_m);
        vertex.material = ObstacleMaterial::kBoards;
        mesh.vertices.push_back(vertex);
      }
    }
    const auto columns = static_cast<std::uint32_t>(us.size());
    for (std::uint32_t row = 0; row + 1 < vs.size(); ++row) {
      for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        const std::uint32_t a = first + row * columns + column, b = a + 1, d = a + columns, c = d + 1;
        if (side > 0.0) {
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        } else {
          mesh.triangles.push_back({a, c, b});
          mesh.triangles.push_back({a, d, c});
        }
      }
    }
  }
}

// Facets with the normals of the hull half worn round. Each takes the granite from the side that it mostly
// faces.
void add_rock(const Rock& rock, const HeightField& ground, ObstacleMesh& mesh) {
  constexpr double kWorn = 0.4;
  const Chance chance(rock.position_m, rock.seed);
  const ConvexHull hull = hull_of(rock);
  const RockFrame frame = placed(rock, ground);
  const auto corners_of = [&](const std::array<std::uint32_t, 3>& facet) {
    return std::array{hull.vertices_m[facet[0]], hull.vertices_m[facet[1]], hull.vertices_m[facet[2]]};
  };
  std::vector<glm::dvec3> round(hull.vertices_m.size(), glm::dvec3(0.0));
  for (const std::array<std::uint32_t, 3>& facet : hull.triangles) {
    const auto [a, b, c] = corners_of(facet);
    for (const std::uint32_t corner : facet) round[corner] += glm::cross(b - a, c - a);
  }
  // On large rocks the grain is drawn larger, or one would see it repeat.
  const double map_m =
      kGraniteM * std::max(1.0, std::max({rock.size_m.x, rock.size_m.y, rock.size_m.z}) / 6.0);
  const glm::vec2 shift(chance(1), chance(2));
  const float tone = 0.82f + 0.42f * chance(3);
  for (const std::array<std::uint32_t, 3>& facet : hull.triangles) {
    const auto [a, b, c] = corners_of(facet);
    const glm::dvec3 flat = glm::normalize(glm::cross(b - a, c - a));
    const glm::dvec3 towards = glm::abs(flat);
    const int axis = towards.x >= towards.y && towards.x >= towards.z ? 0 : towards.y >= towards.z ? 1 : 2;
    const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    const double side = flat[axis] < 0.0 ? -1.0 : 1.0;
    glm::dvec3 along(0.0);
    along[u_axis] = side;
    const std::uint32_t first = next_index(mesh);
    for (const std::uint32_t corner : facet) {
      const glm::dvec3 at_m = hull.vertices_m[corner];
      ObstacleVertex vertex;
      vertex.place_m = frame.origin_m + frame.axes * at_m;
      const glm::dvec3 worn = glm::normalize(glm::mix(flat, glm::normalize(round[corner]), kWorn));
      vertex.facing = glm::vec3(frame.axes * worn);
      vertex.along = across(vertex.facing, glm::vec3(frame.axes * along));
      vertex.on_map = shift + glm::vec2(side * at_m[u_axis] / map_m, at_m[v_axis] / map_m) +
                      0.37f * static_cast<float>(axis);
      vertex.above_ground_m = above_m(ground, vertex.place_m);
      // Bleached where rain runs off, stained by soil and moss below.
      const float high =
          std::clamp(vertex.above_ground_m / static_cast<float>(0.6 * rock.size_m.z), 0.0f, 1.0f);
      const float own = tone * (0.86f + 0.28f * chance(100 + corner));
      vertex.tint = own * glm::mix(glm::vec3(0.70f, 0.74f, 0.58f), glm::vec3(1.06f, 1.05f, 1.03f), high);
      vertex.material = ObstacleMaterial::kGranite;
      mesh.vertices.push_back(vertex);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
}

}  // namespace

void add_mesh(const Obstacle& obstacle, const HeightField& ground, ObstacleMesh& mesh,
              double trunk_sagitta_m) {
  if (const auto* trunk = std::get_if<Trunk>(&obstacle)) add_trunk(*trunk, ground, trunk_sagitta_m, mesh);
  if (const auto* block = std::get_if<Block>(&obstacle)) add_block(*block, ground, mesh);
  if (const auto* rock = std::get_if<Rock>(&obstacle)) add_rock(*rock, ground, mesh);
}

}  // namespace prairie
