#include "render/things/obstacle_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>

#include "lod/frustum.h"
#include "render/gl/gl_objects.h"
#include "render/gl/shader_program.h"
#include "render/gl/vertex_layout.h"
#include "render/things/obstacle_texture.h"
#include "render/things/shapes/obstacle_mesh.h"
#include "render/things/shapes/wall_mesh.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

/// Floats are fine to a thousandth of a millimetre within it; small enough to tell near trunks from far ones.
constexpr double kSquareM = 16.0;

struct DeviceVertex {
  glm::vec3 place_m;
  glm::vec3 facing;
  glm::vec3 along;
  glm::vec3 map_and_height;
  glm::u8vec4 tint_and_layer;
};

constexpr std::array<VertexAttribute, 5> kVertexAttributes{{
    {3, GL_FLOAT, offsetof(DeviceVertex, place_m)},
    {3, GL_FLOAT, offsetof(DeviceVertex, facing)},
    {3, GL_FLOAT, offsetof(DeviceVertex, along)},
    {3, GL_FLOAT, offsetof(DeviceVertex, map_and_height)},
    {4, GL_UNSIGNED_BYTE, offsetof(DeviceVertex, tint_and_layer)},
}};

DeviceVertex device_vertex(const ObstacleVertex& vertex, glm::dvec3 origin_m) {
  const glm::vec3 tint = glm::clamp(vertex.tint * 127.5f, glm::vec3(0.0f), glm::vec3(255.0f));
  return {glm::vec3(vertex.place_m - origin_m), vertex.facing, vertex.along,
          glm::vec3(vertex.on_map, vertex.above_ground_m),
          glm::u8vec4(glm::vec4(tint + 0.5f, static_cast<float>(vertex.material)))};
}

/// Triangles with an origin of their own. They lie in the order near trunks, all else, far trunks, so that
/// what a frame draws of it is in one piece.
struct Square {
  glm::dvec3 origin_m{0.0};
  AlignedBox box{glm::dvec3(1e9), glm::dvec3(-1e9)};
  std::size_t first_index = 0;
  std::size_t near_trunks = 0, others = 0, far_trunks = 0;  // indices
};

struct Squares {
  std::vector<Square> squares;
  std::vector<DeviceVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// Near trunks, all else, far trunks.
using Meshes = std::array<ObstacleMesh, 3>;

Meshes meshes_of(const StandingThings& things, const HeightField& ground) {
  Meshes meshes;
  for (const Obstacle& obstacle : things.obstacles) {
    if (std::holds_alternative<Trunk>(obstacle)) {
      add_mesh(obstacle, ground, meshes[0], kTrunkSagittaM);
      add_mesh(obstacle, ground, meshes[2], kFarTrunkSagittaM);
    } else {
      add_mesh(obstacle, ground, meshes[1]);
    }
  }
  for (const Wall& wall : things.walls) add_mesh(wall, ground, meshes[1]);
  return meshes;
}

/// Appends the vertices and indices of some triangles, as seen from the square's origin; how many indices.
std::size_t add_triangles(const ObstacleMesh& mesh, std::span<const std::size_t> triangles, Square& square,
                          Squares& sorted) {
  std::unordered_map<std::uint32_t, std::uint32_t> taken;
  for (const std::size_t triangle : triangles) {
    for (const std::uint32_t corner : mesh.triangles[triangle]) {
      const ObstacleVertex& vertex = mesh.vertices[corner];
      const auto [entry, is_new] =
          taken.try_emplace(corner, static_cast<std::uint32_t>(sorted.vertices.size()));
      if (is_new) sorted.vertices.push_back(device_vertex(vertex, square.origin_m));
      sorted.indices.push_back(entry->second);
      square.box = {glm::min(square.box.min_m, vertex.place_m), glm::max(square.box.max_m, vertex.place_m)};
    }
  }
  return 3 * triangles.size();
}

Squares sorted_into_squares(const Meshes& meshes) {
  std::map<std::pair<double, double>, std::array<std::vector<std::size_t>, 3>> triangles_at;
  for (std::size_t part = 0; part < meshes.size(); ++part) {
    for (std::size_t n = 0; n < meshes[part].triangles.size(); ++n) {
      const glm::dvec3 place_m = meshes[part].vertices[meshes[part].triangles[n][0]].place_m;
      triangles_at[{std::floor(place_m.x / kSquareM), std::floor(place_m.y / kSquareM)}][part].push_back(n);
    }
  }
  Squares sorted;
  for (const auto& [at, triangles] : triangles_at) {
    Square square;
    const std::size_t some = triangles[1].empty() ? 0 : 1;  // near and far trunks come together
    const std::uint32_t corner = meshes[some].triangles[triangles[some][0]][0];
    square.origin_m = {kSquareM * (at.first + 0.5), kSquareM * (at.second + 0.5),
                       std::round(meshes[some].vertices[corner].place_m.z)};
    square.first_index = sorted.indices.size();
    square.near_trunks = add_triangles(meshes[0], triangles[0], square, sorted);
    square.others = add_triangles(meshes[1], triangles[1], square, sorted);
    square.far_trunks = add_triangles(meshes[2], triangles[2], square, sorted);
    sorted.squares.push_back(square);
  }
  return sorted;
}

}  // namespace

struct ObstaclePass::Device {
  Device(const std::filesystem::path& shader_folder, const Meshes& meshes)
      : program(make_program(shader_folder, {"pass/obstacle.vert", "pass/obstacle.frag"})) {
    std::array<bool, kObstacleMaterials> materials{};
    for (const ObstacleMesh& mesh : meshes) {
      for (const ObstacleVertex& vertex : mesh.vertices)
        materials[static_cast<std::size_t>(vertex.material)] = true;
    }
    texture = paint_obstacle_texture(shader_folder, materials);
    Squares sorted = sorted_into_squares(meshes);
    squares = std::move(sorted.squares);
    vertices.upload(std::span<const DeviceVertex>(sorted.vertices));
    indices.upload(std::span<const std::uint32_t>(sorted.indices));
    set_vertices(vertex_array, vertices, sizeof(DeviceVertex));
    glVertexArrayElementBuffer(vertex_array.get(), indices.get());
  }

  GlProgram program;
  GlVertexArray vertex_array = make_vertex_array(kVertexAttributes, "obstacles");
  ObstacleTexture texture;
  GlBuffer vertices{"obstacle vertices"};
  GlBuffer indices{"obstacle indices"};
  std::vector<Square> squares;
};

ObstaclePass::ObstaclePass(std::filesystem::path shader_folder) : shader_folder_(std::move(shader_folder)) {}

ObstaclePass::~ObstaclePass() = default;

void ObstaclePass::set(const StandingThings& things, const HeightField& ground) {
  const Meshes meshes = meshes_of(things, ground);
  const bool is_empty =
      std::ranges::all_of(meshes, [](const ObstacleMesh& mesh) { return mesh.triangles.empty(); });
  device_ = is_empty ? nullptr : std::make_unique<Device>(shader_folder_, meshes);
  seen_.clear();
}

bool ObstaclePass::prepare(const Camera& camera) {
  seen_.clear();
  triangles_drawn_ = 0;
  if (!device_) return false;
  const Frustum frustum(camera);
  for (std::size_t n = 0; n < device_->squares.size(); ++n) {
    const Square& square = device_->squares[n];
    if (!frustum.may_see(square.box)) continue;
    const double distance_m = nearest_distance_m(square.box, camera.eye_m);
    const bool is_far = camera.pixel_m_at(distance_m) > 2.0 * kFarTrunkSagittaM;
    seen_.push_back({distance_m, n, is_far, glm::vec3(square.origin_m - camera.eye_m)});
  }
  std::ranges::stable_sort(seen_, {}, &Seen::distance_m);
  return !seen_.empty();
}

void ObstaclePass::draw() {
  triangles_drawn_ = 0;
  if (seen_.empty()) return;
  const GLuint program = device_->program.get();
  glUseProgram(program);
  glBindVertexArray(device_->vertex_array.get());
  glBindTextureUnit(layouts::kObstacleAlbedoUnit, device_->texture.albedo.get());
  glBindTextureUnit(layouts::kObstacleSurfaceUnit, device_->texture.surface.get());
  for (const Seen& seen : seen_) {
    const Square& square = device_->squares[seen.square];
    glProgramUniform3fv(program, layouts::kObstacleOrigin, 1, &seen.origin_from_eye_m[0]);
    const std::size_t first = square.first_index + (seen.is_far ? square.near_trunks : 0);
    const std::size_t indices = square.others + (seen.is_far ? square.far_trunks : square.near_trunks);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
    triangles_drawn_ += indices / 3;
  }
}

}  // namespace prairie
