#include "render/obstacle_pass.h"

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
#include "render/gl_objects.h"
#include "render/obstacle_mesh.h"
#include "render/obstacle_texture.h"
#include "render/shader_program.h"
#include "render/wall_mesh.h"

namespace prairie {
namespace {

/// Floats are fine enough for tenths of a millimetre within it.
constexpr double kSquareM = 64.0;

struct DeviceVertex {
  glm::vec3 place_m;
  glm::vec3 facing;
  glm::vec3 along;
  glm::vec3 map_and_height;
  glm::u8vec4 tint_and_layer;
};

DeviceVertex device_vertex(const ObstacleVertex& vertex, glm::dvec3 origin_m) {
  const glm::vec3 tint = glm::clamp(vertex.tint * 127.5f, glm::vec3(0.0f), glm::vec3(255.0f));
  return {glm::vec3(vertex.place_m - origin_m), vertex.facing, vertex.along,
          glm::vec3(vertex.on_map, vertex.above_ground_m),
          glm::u8vec4(glm::vec4(tint + 0.5f, static_cast<float>(vertex.material)))};
}

/// Things whose triangles begin in it.
struct Square {
  glm::dvec3 origin_m{0.0};
  AlignedBox box;
  std::size_t first_index = 0;
  GLsizei indices = 0;
};

struct Squares {
  std::vector<Square> squares;
  std::vector<DeviceVertex> vertices;
  std::vector<std::uint32_t> indices;
};

Squares sorted_into_squares(const ObstacleMesh& mesh) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> triangles_of;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    const glm::dvec3 place_m = mesh.vertices[mesh.triangles[n][0]].place_m;
    triangles_of[{std::floor(place_m.x / kSquareM), std::floor(place_m.y / kSquareM)}].push_back(n);
  }
  Squares sorted;
  for (const auto& [at, triangles] : triangles_of) {
    const double first_z_m = mesh.vertices[mesh.triangles[triangles[0]][0]].place_m.z;
    Square square;
    square.origin_m = {kSquareM * (at.first + 0.5), kSquareM * (at.second + 0.5), std::round(first_z_m)};
    square.box = {glm::dvec3(1e9), glm::dvec3(-1e9)};
    square.first_index = sorted.indices.size();
    square.indices = static_cast<GLsizei>(3 * triangles.size());
    std::unordered_map<std::uint32_t, std::uint32_t> taken;
    for (const std::size_t triangle : triangles) {
      for (const std::uint32_t corner : mesh.triangles[triangle]) {
        const ObstacleVertex& vertex = mesh.vertices[corner];
        const auto [entry, is_new] = taken.try_emplace(corner, static_cast<std::uint32_t>(sorted.vertices.size()));
        if (is_new) sorted.vertices.push_back(device_vertex(vertex, square.origin_m));
        sorted.indices.push_back(entry->second);
        square.box = {glm::min(square.box.min_m, vertex.place_m), glm::max(square.box.max_m, vertex.place_m)};
      }
    }
    sorted.squares.push_back(square);
  }
  return sorted;
}

}  // namespace

struct ObstaclePass::Device {
  Device(const std::filesystem::path& shader_folder, const ObstacleMesh& mesh)
      : program(make_program(shader_folder, {"pass/obstacle.vert", "pass/obstacle.frag"})),
        vertex_array(make_vertex_array()) {
    std::array<bool, kObstacleMaterials> materials{};
    for (const ObstacleVertex& vertex : mesh.vertices) materials[static_cast<std::size_t>(vertex.material)] = true;
    texture = paint_obstacle_texture(shader_folder, materials);
    Squares sorted = sorted_into_squares(mesh);
    squares = std::move(sorted.squares);
    vertices.upload(std::span<const DeviceVertex>(sorted.vertices));
    indices.upload(std::span<const std::uint32_t>(sorted.indices));
    const GLuint array = vertex_array.get();
    glVertexArrayVertexBuffer(array, 0, vertices.get(), 0, sizeof(DeviceVertex));
    glVertexArrayElementBuffer(array, indices.get());
    for (const auto& [index, offset] : {std::pair(0u, offsetof(DeviceVertex, place_m)),
                                        std::pair(1u, offsetof(DeviceVertex, facing)),
                                        std::pair(2u, offsetof(DeviceVertex, along)),
                                        std::pair(3u, offsetof(DeviceVertex, map_and_height))})
      glVertexArrayAttribFormat(array, index, 3, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribFormat(array, 4, 4, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(DeviceVertex, tint_and_layer));
    for (const GLuint index : {0u, 1u, 2u, 3u, 4u}) {
      glEnableVertexArrayAttrib(array, index);
      glVertexArrayAttribBinding(array, index, 0);
    }
  }

  GlProgram program;
  GlVertexArray vertex_array;
  ObstacleTexture texture;
  GlBuffer vertices;
  GlBuffer indices;
  std::vector<Square> squares;
};

ObstaclePass::ObstaclePass(std::filesystem::path shader_folder) : shader_folder_(std::move(shader_folder)) {}

ObstaclePass::~ObstaclePass() = default;

void ObstaclePass::set(const StandingThings& things, const HeightField& ground) {
  ObstacleMesh mesh;
  for (const Obstacle& obstacle : things.obstacles) add_mesh(obstacle, ground, mesh);
  for (const Wall& wall : things.walls) add_mesh(wall, ground, mesh);
  device_ = mesh.triangles.empty() ? nullptr : std::make_unique<Device>(shader_folder_, mesh);
  seen_.clear();
}

void ObstaclePass::prepare(const Camera& camera) {
  seen_.clear();
  if (!device_) return;
  const Frustum frustum(camera);
  for (std::size_t n = 0; n < device_->squares.size(); ++n) {
    const Square& square = device_->squares[n];
    if (frustum.may_see(square.box))
      seen_.push_back({nearest_distance_m(square.box, camera.eye_m), n, glm::vec3(square.origin_m - camera.eye_m)});
  }
  std::ranges::stable_sort(seen_, {}, &Seen::distance_m);
}

void ObstaclePass::draw() {
  triangles_drawn_ = 0;
  if (seen_.empty()) return;
  const GLuint program = device_->program.get();
  glUseProgram(program);
  glBindVertexArray(device_->vertex_array.get());
  glBindTextureUnit(1, device_->texture.albedo.get());
  glBindTextureUnit(2, device_->texture.surface.get());
  glEnable(GL_CULL_FACE);  // what stands is closed above the ground
  for (const Seen& seen : seen_) {
    const Square& square = device_->squares[seen.square];
    glProgramUniform3fv(program, 0, 1, &seen.origin_from_eye_m[0]);
    glDrawElements(GL_TRIANGLES, square.indices, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(square.first_index * sizeof(std::uint32_t)));
    triangles_drawn_ += static_cast<std::uint64_t>(square.indices) / 3;
  }
  glDisable(GL_CULL_FACE);
}

}  // namespace prairie
