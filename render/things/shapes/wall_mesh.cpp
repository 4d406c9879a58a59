#include "render/things/shapes/wall_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

using Ring = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

double area_m2(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t n = 0; n < ring.size(); ++n)
    twice += cross(ring[n] - ring[0], ring[(n + 1) % ring.size()] - ring[0]);
  return 0.5 * twice;
}

/// Counter-clockwise, no point twice in succession.
Ring tidied(Ring ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (area_m2(ring) < 0.0) std::ranges::reverse(ring);
  return ring;
}

/// Each edge moved outwards (inwards where negative); no corner goes farther than three times that.
Ring moved_out(const Ring& ring, double by_m) {
  constexpr double kFarthest = 3.0;
  const auto outward = [&](std::size_t n) {
    const glm::dvec2 along = glm::normalize(ring[(n + 1) % ring.size()] - ring[n % ring.size()]);
    return glm::dvec2(along.y, -along.x);
  };
  Ring moved;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const glm::dvec2 before = outward(n + ring.size() - 1), after = outward(n);
    const double share = std::max(1.0 + glm::dot(before, after), 1e-9);
    glm::dvec2 mitre = (before + after) / share;
    const double length = glm::length(mitre);
    if (length > kFarthest) mitre *= kFarthest / length;
    moved.push_back(ring[n] + by_m * mitre);
  }
  return moved;
}

bool is_sound(const WallPolygon& polygon) {
  try {
    convex_pieces(polygon);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

/// Points that are the same but for rounding become one.
class Welder {
 public:
  std::uint32_t operator()(glm::dvec2 point_m) {
    const auto column = static_cast<std::int64_t>(std::floor(point_m.x / kSameM));
    const auto row = static_cast<std::int64_t>(std::floor(point_m.y / kSameM));
    for (std::int64_t y = row - 1; y <= row + 1; ++y) {
      for (std::int64_t x = column - 1; x <= column + 1; ++x) {
        const auto found = at_.find({x, y});
        if (found != at_.end()) return found->second;
      }
    }
    const auto index = static_cast<std::uint32_t>(points_m.size());
    points_m.push_back(point_m);
    at_.emplace(std::pair(column, row), index);
    return index;
  }
  std::vector<glm::dvec2> points_m;

 private:
  static constexpr double kSameM = 1e-5;
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> at_;
};

struct Lattice {
  glm::dvec2 origin_m{0.0};
  double step_m = 1.0;
};

constexpr double kOnLineM = 1e-6;

/// The part of a convex polygon on one side of a line across an axis; corners on the line belong to both.
Ring clipped(const Ring& ring, int axis, double line_m, double side) {
  Ring part;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    const glm::dvec2 a = ring[n], b = ring[(n + 1) % ring.size()];
    const double da = side * (a[axis] - line_m), db = side * (b[axis] - line_m);
    if (da >= -kOnLineM) part.push_back(a);
    if ((da < -kOnLineM && db > kOnLineM) || (da > kOnLineM && db < -kOnLineM)) {
      glm::dvec2 on_line = a + da / (da - db) * (b - a);
      on_line[axis] = line_m;
      part.push_back(on_line);
    }
  }
  return part;
}

/// Calls `use` for the parts of a convex polygon in the lattice's squares. Halved at the middle line again
/// and again, so that long thin pieces cost no more than the squares they cross.
template <typename Use>
void cut(const Ring& ring, const Lattice& lattice, const Use& use) {
  for (int axis = 0; axis < 2; ++axis) {
    double low_m = ring[0][axis], high_m = low_m;
    for (const glm::dvec2 p : ring) {
      low_m = std::min(low_m, p[axis]);
      high_m = std::max(high_m, p[axis]);
    }
    const double first = std::ceil((low_m + 2.0 * kOnLineM - lattice.origin_m[axis]) / lattice.step_m);
    const double last = std::floor((high_m - 2.0 * kOnLineM - lattice.origin_m[axis]) / lattice.step_m);
    if (first > last) continue;
    const double line_m = lattice.origin_m[axis] + lattice.step_m * std::floor(0.5 * (first + last));
    for (const double side : {-1.0, 1.0}) {
      const Ring part = clipped(ring, axis, line_m, side);
      if (part.size() >= 3) cut(part, lattice, use);
    }
    return;
  }
  use(ring);
}

struct Top {
  std::vector<glm::dvec2> points_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Top top_of(const WallPolygon& polygon) {
  // Small enough to follow the ground, but never more than some ten thousand squares.
  constexpr double kStepM = 1.5, kMostSquares = 4096.0;
  double size_m2 = std::abs(area_m2(polygon.outer_m)), length_m = 0.0;
  for (const Ring& hole : polygon.holes_m) size_m2 -= std::abs(area_m2(hole));
  for (std::size_t n = 0; n < polygon.outer_m.size(); ++n)
    length_m += glm::distance(polygon.outer_m[n], polygon.outer_m[(n + 1) % polygon.outer_m.size()]);
  Lattice lattice;
  lattice.step_m =
      std::max({kStepM, std::sqrt(std::max(size_m2, 0.0) / kMostSquares), length_m / kMostSquares});
  // Outlines on round numbers of metres must not lie along it.
  lattice.origin_m = polygon.outer_m[0] + lattice.step_m * glm::dvec2(0.381, 0.367);

  Welder weld;
  Top top;
  for (const Ring& piece : convex_pieces(polygon)) {
    cut(piece, lattice, [&](const Ring& part) {
      std::vector<std::uint32_t> corners;
      for (const glm::dvec2 p : part) {
        const std::uint32_t corner = weld(p);
        if (corners.empty() || (corners.back() != corner && corners.front() != corner))
          corners.push_back(corner);
      }
      for (std::size_t n = 2; n < corners.size(); ++n)
        top.triangles.push_back({corners[0], corners[n - 1], corners[n]});
    });
  }
  top.points_m = std::move(weld.points_m);
  return top;
}

/// The edges that one triangle only has, one after another around each ring.
std::vector<std::vector<std::uint32_t>> rings_of(const Top& top) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const std::array<std::uint32_t, 3>& triangle : top.triangles) {
    for (std::size_t n = 0; n < 3; ++n) ++edges[{triangle[n], triangle[(n + 1) % 3]}];
  }
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge.second, edge.first})) next.insert(edge);
  }
  std::vector<std::vector<std::uint32_t>> rings;
  while (!next.empty()) {
    std::vector<std::uint32_t> ring;
    for (auto edge = next.begin(); edge != next.end(); edge = next.find(ring.back())) {
      if (ring.empty()) ring.push_back(edge->first);
      ring.push_back(edge->second);
      next.erase(edge);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

void add_extruded(const WallPolygon& polygon, double height_m, const HeightField& ground,
                  ObstacleMesh& mesh) {
  const Top top = top_of(polygon);
  const auto ground_m = [&](glm::dvec2 p) { return static_cast<double>(ground.height_m(p)); };
  const auto tint_of = [](std::uint32_t point) {
    const float chance = Kernels{}.unit_from_u32(Kernels{}.hash_u32(point + 1));
    return glm::mix(glm::vec3(0.88f, 0.90f, 0.84f), glm::vec3(1.10f, 1.08f, 1.04f), chance);
  };
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t n = 0; n < top.points_m.size(); ++n) {
    const glm::dvec2 p = top.points_m[n];
    ObstacleVertex vertex;
    vertex.place_m = {p, ground_m(p) + height_m};
    vertex.facing = ground.normal(p);
    vertex.along = glm::normalize(glm::vec3(1.0f, 0.0f, -vertex.facing.x / vertex.facing.z));
    vertex.on_map = glm::vec2((p - top.points_m[0]) / kGraniteM);
    vertex.tint = 0.85f * tint_of(n);
    vertex.above_ground_m = static_cast<float>(height_m);
    vertex.material = ObstacleMaterial::kGranite;  // large flat stones that hold it together
    mesh.vertices.push_back(vertex);
  }
  for (const std::array<std::uint32_t, 3>& triangle : top.triangles)
    mesh.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});

  for (const std::vector<std::uint32_t>& ring : rings_of(top)) {
    double length_m = 0.0;
    for (std::size_t n = 1; n < ring.size(); ++n)
      length_m += glm::distance(top.points_m[ring[n - 1]], top.points_m[ring[n]]);
    const double maps = std::max(1.0, std::round(length_m / kDryStoneM));
    double passed_m = 0.0;
    for (std::size_t n = 1; n < ring.size(); ++n) {
      const glm::dvec2 a = top.points_m[ring[n - 1]], b = top.points_m[ring[n]];
      const glm::dvec2 along = glm::normalize(b - a);
      const double step_m = glm::distance(a, b);
      const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const bool is_end : {false, true}) {
        const glm::dvec2 p = is_end ? b : a;
        const float u = static_cast<float>(maps * (passed_m + (is_end ? step_m : 0.0)) / length_m);
        for (const double above_m : {-kIntoGroundM, height_m}) {
          ObstacleVertex vertex;
          vertex.place_m = {p, ground_m(p) + above_m};
          vertex.facing = glm::vec3(along.y, -along.x, 0.0);
          vertex.along = glm::vec3(glm::dvec3(along, 0.0));
          vertex.on_map = {u, static_cast<float>((above_m - height_m) / kDryStoneHighM)};
          vertex.tint = tint_of(ring[is_end ? n : n - 1]);
          vertex.above_ground_m = static_cast<float>(above_m);
          vertex.material = ObstacleMaterial::kDryStone;
          mesh.vertices.push_back(vertex);
        }
      }
      mesh.triangles.push_back({base, base + 2, base + 3});
      mesh.triangles.push_back({base, base + 3, base + 1});
      passed_m += step_m;
    }
  }
}

}  // namespace

std::vector<WallPolygon> standing_polygons(const Wall& wall) {
  if (wall.height_m <= 0.0) return {};
  convex_pieces(wall.outline);  // refuses what is no outline
  if (wall.walkers == WallSide::kOutside) return {wall.outline};
  std::vector<WallPolygon> polygons;
  const Ring outer = tidied(wall.outline.outer_m);
  constexpr double kThinnestM = 0.004;
  for (double thickness_m = kWallThicknessM; thickness_m > kThinnestM; thickness_m *= 0.5) {
    WallPolygon belt{moved_out(outer, thickness_m), {outer}};
    if (!is_sound(belt)) continue;
    polygons.push_back(std::move(belt));
    break;
  }
  for (const Ring& points : wall.outline.holes_m) {
    const Ring hole = tidied(points);
    WallPolygon belt{hole, {moved_out(hole, -kWallThicknessM)}};
    polygons.push_back(is_sound(belt) ? std::move(belt) : WallPolygon{hole, {}});
  }
  return polygons;
}

void add_mesh(const Wall& wall, const HeightField& ground, ObstacleMesh& mesh) {
  for (const WallPolygon& polygon : standing_polygons(wall))
    add_extruded(polygon, wall.height_m, ground, mesh);
}

}  // namespace prairie
