#include "render/things/shapes/solid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

using Triangle = std::array<std::uint16_t, 3>;

SolidMesh icosahedron() {
  const float golden = std::numbers::phi_v<float>;
  SolidMesh mesh;
  // Corners of three golden rectangles, one in each plane of the axes.
  for (int axis = 0; axis < 3; ++axis) {
    for (const float a : {-1.0f, 1.0f}) {
      for (const float b : {-golden, golden}) {
        glm::vec3 corner(0.0f);
        corner[axis] = a;
        corner[(axis + 1) % 3] = b;
        corner = glm::normalize(corner);
        mesh.vertices.push_back({corner, corner});
      }
    }
  }
  // Faces are the triples of corners that are neighbours of one another.
  const float edge = 2.0f / std::sqrt(1.0f + golden * golden);
  const auto neighbours = [&](std::size_t a, std::size_t b) {
    return glm::distance(mesh.vertices[a].place, mesh.vertices[b].place) < 1.1f * edge;
  };
  for (std::size_t a = 0; a < mesh.vertices.size(); ++a) {
    for (std::size_t b = a + 1; b < mesh.vertices.size(); ++b) {
      for (std::size_t c = b + 1; c < mesh.vertices.size(); ++c) {
        if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
        const auto place = [&](std::size_t n) { return mesh.vertices[n].place; };
        const bool is_outward =
            glm::dot(glm::cross(place(b) - place(a), place(c) - place(a)), place(a)) > 0.0f;
        for (const std::size_t n : {a, is_outward ? b : c, is_outward ? c : b})
          mesh.indices.push_back(static_cast<std::uint16_t>(n));
      }
    }
  }
  return mesh;
}

void subdivide(SolidMesh& sphere) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> middles;
  const auto middle = [&](std::uint16_t a, std::uint16_t b) {
    const auto [entry, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint16_t>(sphere.vertices.size()));
    if (is_new) {
      const glm::vec3 place = glm::normalize(sphere.vertices[a].place + sphere.vertices[b].place);
      sphere.vertices.push_back({place, place});
    }
    return entry->second;
  };
  const std::vector<std::uint16_t> coarse = std::move(sphere.indices);
  sphere.indices = {};
  for (std::size_t n = 0; n < coarse.size(); n += 3) {
    const std::uint16_t a = coarse[n], b = coarse[n + 1], c = coarse[n + 2];
    const std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      sphere.indices.insert(sphere.indices.end(), part.begin(), part.end());
  }
}

void add_quad(SolidMesh& mesh, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  for (const std::size_t n : {a, b, c, a, c, d}) mesh.indices.push_back(static_cast<std::uint16_t>(n));
}

// A part of the wheel's surface: the line from one place to another, turned around the axis.
struct Turned {
  float from_radius, from_y, to_radius, to_y;
  float facing_radius, facing_y;
};

void add_turned(SolidMesh& mesh, const Turned& part) {
  constexpr std::size_t kSegments = 48;
  const std::size_t first = mesh.vertices.size();
  for (std::size_t n = 0; n <= kSegments; ++n) {
    const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(n % kSegments) / kSegments;
    const float x = std::cos(turn), z = std::sin(turn);
    const glm::vec3 facing(part.facing_radius * x, part.facing_y, part.facing_radius * z);
    mesh.vertices.push_back({{part.from_radius * x, part.from_y, part.from_radius * z}, facing});
    mesh.vertices.push_back({{part.to_radius * x, part.to_y, part.to_radius * z}, facing});
  }
  for (std::size_t n = first; n < first + 2 * kSegments; n += 2) add_quad(mesh, n, n + 2, n + 3, n + 1);
}

}  // namespace

SolidMesh sphere_mesh(int subdivisions) {
  SolidMesh mesh = icosahedron();
  for (int n = 0; n < subdivisions; ++n) subdivide(mesh);
  return mesh;
}

SolidMesh box_mesh() {
  // Each face is a grid that has its middle lines twice: between them lies the flat part, beyond them half of
  // each rounded edge.
  static constexpr std::array<float, 8> kSteps{-1.0f, -2.0f / 3, -1.0f / 3, 0.0f,
                                               0.0f,  1.0f / 3,  2.0f / 3,  1.0f};
  const auto sign = [](std::size_t step) { return step < kSteps.size() / 2 ? -1.0f : 1.0f; };
  SolidMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const std::size_t first = mesh.vertices.size();
      for (std::size_t v = 0; v < kSteps.size(); ++v) {
        for (std::size_t u = 0; u < kSteps.size(); ++u) {
          SolidVertex vertex{};
          vertex.place[axis] = vertex.facing[axis] = side;
          vertex.place[(axis + 1) % 3] = sign(u);
          vertex.place[(axis + 2) % 3] = sign(v);
          vertex.facing[(axis + 1) % 3] = kSteps[u];
          vertex.facing[(axis + 2) % 3] = kSteps[v];
          vertex.facing = glm::normalize(vertex.facing);
          mesh.vertices.push_back(vertex);
        }
      }
      for (std::size_t v = 0; v + 1 < kSteps.size(); ++v) {
        for (std::size_t u = 0; u + 1 < kSteps.size(); ++u) {
          const std::size_t corner = first + v * kSteps.size() + u;
          add_quad(mesh, corner, corner + 1, corner + kSteps.size() + 1, corner + kSteps.size());
        }
      }
    }
  }
  return mesh;
}

SolidMesh wheel_mesh() {
  using layouts::kHubRadius;
  using layouts::kRimInside;
  constexpr float kSpokeHalf = 0.3f;  // half their thickness, as a share of the wheel's
  SolidMesh mesh;
  for (const float side : {-1.0f, 1.0f}) {
    for (const Turned& part :
         {Turned{kRimInside, side, 1.0f, side, 0.0f, side},
          Turned{kHubRadius, side * kSpokeHalf, kRimInside, side * kSpokeHalf, 0.0f, side},
          Turned{0.0f, side, kHubRadius, side, 0.0f, side}})
      add_turned(mesh, part);
  }
  add_turned(mesh, {1.0f, -1.0f, 1.0f, 1.0f, 1.0f, 0.0f});
  add_turned(mesh, {kRimInside, -1.0f, kRimInside, 1.0f, -1.0f, 0.0f});
  add_turned(mesh, {kHubRadius, -1.0f, kHubRadius, 1.0f, 1.0f, 0.0f});
  return mesh;
}

}  // namespace prairie
