#include "tests/render/grass/sward_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/plant.h"
#include "lod/sward/sward_sample.h"

namespace prairie {
namespace {

struct Vertex {
  glm::vec3 position_m;
  glm::vec3 left, right;  // normals
  float t;
  float sign;
};

// The vertices of shaders/pass/grow.comp.
std::vector<Vertex> vertices_of(const Blade& blade, glm::vec3 to_eye, std::size_t count) {
  Kernels kernels;
  const Kernels::BladeCurve curve = resting_curve(blade);
  std::vector<Vertex> vertices;
  for (std::size_t n = 0; n < count; ++n) {
    Vertex vertex;
    vertex.t = static_cast<float>(n / 2) / static_cast<float>(count / 2);
    vertex.sign = n + 1 == count ? 0.0f : (n % 2 == 0 ? -1.0f : 1.0f);
    const glm::vec3 centre =
        kernels.hermite_point(curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m, vertex.t);
    const glm::vec3 along = kernels.hermite_derivative(curve.base_m, curve.tip_m, curve.base_tangent_m,
                                                       curve.tip_tangent_m, vertex.t);
    const auto surface = kernels.blade_surface(along, curve.side, to_eye);
    vertex.position_m =
        centre + surface.side * (0.5f * vertex.sign * blade.width_m * kernels.blade_profile(vertex.t));
    vertex.left = surface.left;
    vertex.right = surface.right;
    vertices.push_back(vertex);
  }
  return vertices;
}

// A triangle slid along the view onto the ground; z is the height it had.
struct Triangle {
  std::array<glm::dvec3, 3> corners;
  std::uint32_t blade;
  std::uint32_t first_vertex;
};

glm::dvec3 shares_at(const Triangle& triangle, double x, double y) {
  const auto& [a, b, c] = triangle.corners;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  const double of_b = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
  const double of_c = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
  return {1.0 - of_b - of_c, of_b, of_c};
}

struct Rays {
  double side_m;
  int columns, rows;
  struct Hit {
    float height_m = -1.0f;
    std::uint32_t triangle = 0;
    float x = 0.0f, y = 0.0f;  // shares of the second and third corner
  };
  std::vector<Hit> hits;

  void add(const Triangle& triangle, std::uint32_t index) {
    const auto& corners = triangle.corners;
    const double step_x = side_m / columns;
    const double step_y = side_m / rows;
    const double low = std::min({corners[0].y, corners[1].y, corners[2].y});
    const double high = std::max({corners[0].y, corners[1].y, corners[2].y});
    const int last = static_cast<int>(std::floor(high / step_y - 0.5));
    for (int row = static_cast<int>(std::ceil(low / step_y - 0.5)); row <= last; ++row) {
      const double y = (row + 0.5) * step_y;
      double from = 1e30;
      double to = -1e30;
      for (int n = 0; n < 3; ++n) {
        const glm::dvec3 a = corners[static_cast<std::size_t>(n)];
        const glm::dvec3 b = corners[static_cast<std::size_t>((n + 1) % 3)];
        if ((a.y - y) * (b.y - y) > 0.0 || a.y == b.y) continue;
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        from = std::min(from, x);
        to = std::max(to, x);
      }
      const int last_column = static_cast<int>(std::ceil(to / step_x - 0.5)) - 1;
      for (int column = static_cast<int>(std::ceil(from / step_x - 0.5)); column <= last_column; ++column)
        add_ray(triangle, index, column, row, (column + 0.5) * step_x, y);
    }
  }

  void add_ray(const Triangle& triangle, std::uint32_t index, int column, int row, double x, double y) {
    const glm::dvec3 shares = shares_at(triangle, x, y);
    const auto height =
        static_cast<float>(shares.x * triangle.corners[0].z + shares.y * triangle.corners[1].z +
                           shares.z * triangle.corners[2].z);
    const auto wrapped = [](int n, int count) {
      return static_cast<std::size_t>((n % count + count) % count);
    };
    Hit& hit = hits[wrapped(row, rows) * static_cast<std::size_t>(columns) + wrapped(column, columns)];
    if (height <= std::max(hit.height_m, 0.0f)) return;
    hit = {height, index, static_cast<float>(shares.y), static_cast<float>(shares.z)};
  }
};

Meadow meadow_of(std::span<const SwardLayer> layers, double side_m, std::uint64_t seed) {
  Meadow meadow;
  meadow.seed = seed;
  meadow.extent_m = glm::dvec2(side_m);
  for (const SwardLayer& layer : layers) {
    PlantedSpecies planted;
    planted.species.params = *layer.species;
    planted.density_per_m2 = NodeGrid::uniform(static_cast<float>(layer.density_per_m2));
    meadow.species.push_back(std::move(planted));
  }
  return meadow;
}

}  // namespace

SwardPicture picture_of(std::span<const SwardLayer> layers, double side_m, double sin_elevation, double ray_m,
                        int segments, std::uint64_t seed) {
  const double cosine = std::sqrt(1.0 - sin_elevation * sin_elevation);
  SwardPicture picture;
  picture.to_eye = glm::vec3(static_cast<float>(cosine), 0.0f, static_cast<float>(sin_elevation));
  for (const SwardLayer& layer : layers) picture.species.push_back(layer.species);

  const auto vertex_count = static_cast<std::size_t>(2 * segments + 1);
  const Meadow meadow = meadow_of(layers, side_m, seed);
  std::vector<Triangle> triangles;
  const TileRange tiles = tiles_of(meadow);
  for (int j = 0; j <= tiles.last.j; ++j) {
    for (int i = 0; i <= tiles.last.i; ++i) {
      for (Blade blade : plant_tile(meadow, {i, j})) {
        blade.root_m += glm::vec2(tile_origin_m(meadow, {i, j}));
        blade.ground_m = 0.0f;
        const std::vector<Vertex> vertices = vertices_of(blade, picture.to_eye, vertex_count);
        for (std::uint32_t n = 0; n + 2 < vertex_count; ++n) {
          Triangle triangle{{}, static_cast<std::uint32_t>(picture.blades.size()), n};
          for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 p(vertices[n + corner].position_m);
            triangle.corners[corner] = {p.x - p.z * cosine / sin_elevation, p.y, p.z};
          }
          triangles.push_back(triangle);
        }
        picture.blades.push_back({blade, blade.identity >> 26u, std::vector<float>(vertex_count, 0.0f)});
      }
    }
  }

  Rays rays;
  rays.side_m = side_m;
  rays.rows = static_cast<int>(std::lround(side_m / ray_m));
  rays.columns = std::max(1, static_cast<int>(std::lround(side_m * sin_elevation / ray_m)));
  rays.hits.resize(static_cast<std::size_t>(rays.rows) * static_cast<std::size_t>(rays.columns));
  for (std::uint32_t n = 0; n < triangles.size(); ++n) rays.add(triangles[n], n);

  for (const Rays::Hit& hit : rays.hits) {
    picture.rays += 1.0;
    if (hit.height_m <= 0.0f) continue;
    picture.rays_on_blades += 1.0;
    const Triangle& triangle = triangles[hit.triangle];
    std::vector<float>& of_blade = picture.blades[triangle.blade].vertex_rays;
    of_blade[triangle.first_vertex] += 1.0f - hit.x - hit.y;
    of_blade[triangle.first_vertex + 1] += hit.x;
    of_blade[triangle.first_vertex + 2] += hit.y;
  }
  return picture;
}

glm::vec3 SwardPicture::color(const LightParams& light, float shade, int layer) const {
  Kernels kernels;
  glm::dvec3 sum(0.0);
  double count = 1e-9;
  for (const BladeSeen& seen : blades) {
    if (layer >= 0 && seen.layer != static_cast<std::size_t>(layer)) continue;
    const SpeciesParams& of = *species[seen.layer];
    const glm::vec3 root = kernels.root_albedo(of, seen.blade.hue, seen.blade.dryness);
    const glm::vec3 tip = kernels.tip_albedo(of, seen.blade.hue, seen.blade.dryness);
    const std::vector<Vertex> vertices = vertices_of(seen.blade, to_eye, seen.vertex_rays.size());
    for (std::size_t n = 0; n < vertices.size(); ++n) {
      if (seen.vertex_rays[n] == 0.0f) continue;
      const Vertex& vertex = vertices[n];
      const glm::vec3 albedo = kernels.mixed(root, tip, vertex.t);
      const auto half = [&](glm::vec3 normal) {
        return kernels.blade_radiance(light, albedo, of.transmission, of.specular, vertex.t, shade,
                                      glm::dot(normal, light.sun_direction), to_eye.z);
      };
      const float right = 0.5f + 0.5f * vertex.sign;
      const glm::vec3 lit = glm::mix(half(vertex.left), half(vertex.right), right);
      sum += glm::dvec3(lit) * static_cast<double>(seen.vertex_rays[n]);
      count += static_cast<double>(seen.vertex_rays[n]);
    }
  }
  return glm::vec3(sum / count);
}

double SwardPicture::cover_of(int layer) const {
  double count = 0.0;
  for (const BladeSeen& seen : blades) {
    if (seen.layer != static_cast<std::size_t>(layer)) continue;
    for (const float of_vertex : seen.vertex_rays) count += static_cast<double>(of_vertex);
  }
  return count / rays;
}

}  // namespace prairie
