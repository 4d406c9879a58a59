#include "render/grass/ground_mesh.h"

#include <algorithm>
#include <cmath>

namespace prairie {
namespace {

constexpr double kAnchorStepM = 1024.0;

double anchor_height_m(const Meadow& meadow) {
  return std::round(static_cast<double>(meadow.ground.range().min_m));
}

std::int16_t packed(float x) {
  return static_cast<std::int16_t>(std::lround(32767.0f * std::clamp(x, -1.0f, 1.0f)));
}

}  // namespace

glm::dvec3 ground_anchor_m(const Meadow& meadow, glm::dvec3 eye_m) {
  return {kAnchorStepM * std::round(eye_m.x / kAnchorStepM),
          kAnchorStepM * std::round(eye_m.y / kAnchorStepM), anchor_height_m(meadow)};
}

std::array<GroundVertex, kGroundVertices> patch_vertices(const Meadow& meadow, const GroundPatch& patch) {
  const double side_m = patch_side_m(patch.level);
  const double quad_m = side_m / kPatchQuads;
  const glm::dvec2 corner_m = side_m * glm::dvec2(patch.column, patch.row);
  const double base_m = anchor_height_m(meadow);
  std::array<float, kGroundVertices> heights_m;
  meadow.ground.sample_lattice(corner_m, quad_m, kGroundSide, kGroundSide, heights_m);
  std::array<GroundVertex, kGroundVertices> vertices;
  for (std::uint32_t n = 0; n < kGroundVertices; ++n) {
    const glm::vec3 normal =
        meadow.ground.normal(corner_m + quad_m * glm::dvec2(n % kGroundSide, n / kGroundSide));
    vertices[n] = {static_cast<float>(static_cast<double>(heights_m[n]) - base_m),
                   {packed(normal.x), packed(normal.y), packed(normal.z), 0}};
  }
  return vertices;
}

std::vector<std::uint16_t> patch_indices(std::uint8_t coarser_sides) {
  const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
    if ((x == 0 && (coarser_sides & kWest)) || (x == kGroundSide - 1 && (coarser_sides & kEast))) y &= ~1u;
    if ((y == 0 && (coarser_sides & kSouth)) || (y == kGroundSide - 1 && (coarser_sides & kNorth))) x &= ~1u;
    return static_cast<std::uint16_t>(y * kGroundSide + x);
  };
  std::vector<std::uint16_t> indices;
  const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  };
  for (std::uint32_t y = 0; y + 1 < kGroundSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kGroundSide; ++x) {
      const std::uint16_t sw = vertex(x, y), se = vertex(x + 1, y), nw = vertex(x, y + 1),
                          ne = vertex(x + 1, y + 1);
      // Diagonals alternate so that each fan around a stitched vertex closes.
      if ((x + y) % 2 == 0) {
        add(sw, se, ne);
        add(sw, ne, nw);
      } else {
        add(sw, se, nw);
        add(se, ne, nw);
      }
    }
  }
  return indices;
}

}  // namespace prairie
