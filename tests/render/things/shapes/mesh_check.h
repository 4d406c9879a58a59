// What tests ask of meshes that stand on the ground.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "render/things/shapes/obstacle_mesh.h"
#include "tests/generator/test_meadow.h"

namespace prairie {

/// 32 m × 32 m, slopes up to a third.
inline HeightField rolling_ground() {
  return HeightField(grid_from(square_frame(32.0, 2.0), [](glm::dvec2 p) {
    return 5.0 + 1.2 * std::sin(0.25 * p.x) + 0.5 * std::cos(0.2 * p.y + 0.1 * p.x);
  }));
}

struct OpenEdges {
  std::size_t count = 0;
  double highest_above_ground_m = -std::numeric_limits<double>::infinity();
};

/// Edges that have no triangle on their other side; corners a hundredth of a millimetre apart are one.
inline OpenEdges open_edges(const ObstacleMesh& mesh) {
  std::map<std::array<long long, 3>, std::size_t> places;
  const auto place_of = [&](std::uint32_t corner) {
    const glm::dvec3 place_m = mesh.vertices[corner].place_m;
    const std::array at{std::llround(place_m.x * 1e5), std::llround(place_m.y * 1e5),
                        std::llround(place_m.z * 1e5)};
    return places.try_emplace(at, places.size()).first->second;
  };
  std::map<std::pair<std::size_t, std::size_t>, double> edges;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      const std::uint32_t a = triangle[n], b = triangle[(n + 1) % 3];
      edges[{place_of(a), place_of(b)}] =
          static_cast<double>(std::max(mesh.vertices[a].above_ground_m, mesh.vertices[b].above_ground_m));
    }
  }
  OpenEdges open;
  for (const auto& [edge, above_m] : edges) {
    if (edges.contains({edge.second, edge.first})) continue;
    ++open.count;
    open.highest_above_ground_m = std::max(open.highest_above_ground_m, above_m);
  }
  return open;
}

}  // namespace prairie
