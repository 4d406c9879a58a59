#include "render/things/solid_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "render/gl/packed_meshes.h"
#include "render/gl/shader_program.h"
#include "render/things/shapes/solid_mesh.h"
#include "render/things/stone_map.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

// Spheres of 5120, 1280 and 320 triangles; each less than half a pixel off at the radius down to which it is
// drawn.
constexpr std::array<int, 3> kSphereSubdivisions{4, 3, 2};
constexpr std::array<double, 2> kLeastRadiusPx{180.0, 45.0};
constexpr float kRoundestEdgeM = 0.02f;
constexpr glm::vec3 kStoneAlbedo(0.17f, 0.162f, 0.15f);
// By shape.
constexpr std::array<const char*, 3> kShapeDefines{"", "BOARDS", "WHEEL"};

// The lowest point, as seen from the centre.
float lowest_m(const DrawnSolid& solid) {
  const glm::vec3 rise(solid.axes[0].z, solid.axes[1].z, solid.axes[2].z);
  const glm::vec3 reach = solid.half_size_m * glm::abs(rise);
  switch (solid.shape) {
    case DrawnSolid::Shape::kSphere:
      return -glm::length(reach);
    case DrawnSolid::Shape::kBox:
      return -(reach.x + reach.y + reach.z);
    case DrawnSolid::Shape::kWheel:
      return -std::hypot(reach.x, reach.z) - reach.y;
  }
  return 0.0f;
}

SolidParams params_of(const DrawnSolid& solid, glm::dvec3 eye_m) {
  SolidParams params{};
  params.centre_from_eye_m = glm::vec3(solid.centre_m - eye_m);
  params.ground_from_eye_m = params.centre_from_eye_m.z + lowest_m(solid) - solid.above_ground_m;
  params.forward = solid.axes[0];
  params.left = solid.axes[1];
  params.up = solid.axes[2];
  params.half_size_m = solid.half_size_m;
  params.albedo = solid.albedo;
  params.seed = solid.seed;
  switch (solid.shape) {
    case DrawnSolid::Shape::kSphere:
      params.shape = layouts::kSolidSphere;
      params.outline_roughness = solid.roughness_of_outline;
      break;
    case DrawnSolid::Shape::kBox: {
      const glm::vec3 half = solid.half_size_m;
      params.shape = layouts::kSolidBox;
      params.edge_m = std::min(kRoundestEdgeM, 0.3f * std::min({half.x, half.y, half.z}));
      break;
    }
    case DrawnSolid::Shape::kWheel:
      params.shape = layouts::kSolidWheel;
      break;
  }
  return params;
}

double radius_m(const DrawnSolid& solid) {
  const glm::vec3 half = solid.half_size_m;
  return static_cast<double>(std::max({half.x, half.y, half.z}));
}

// How wide a pixel is at its centre.
double pixel_m(const DrawnSolid& solid, const Camera& camera) {
  const double distance_m = camera.is_orthographic() ? 1.0 : glm::distance(solid.centre_m, camera.eye_m);
  return camera.pixel_m() * std::max(distance_m, 1e-3);
}

std::size_t mesh_of(const DrawnSolid& solid, const Camera& camera) {
  constexpr std::size_t kSpheres = kSphereSubdivisions.size();
  if (solid.shape != DrawnSolid::Shape::kSphere) return kSpheres - 1 + static_cast<std::size_t>(solid.shape);
  const double radius_px = radius_m(solid) / pixel_m(solid, camera);
  std::size_t level = 0;
  while (level < kLeastRadiusPx.size() && radius_px < kLeastRadiusPx[level]) ++level;
  return level;
}

// Its DrawnSolid::Shape.
std::size_t shape_of(std::size_t mesh) {
  constexpr std::size_t kSpheres = kSphereSubdivisions.size();
  return mesh < kSpheres ? 0 : mesh - kSpheres + 1;
}

constexpr std::array<VertexAttribute, 2> kVertexAttributes{{
    {3, GL_FLOAT, offsetof(SolidVertex, place)},
    {3, GL_FLOAT, offsetof(SolidVertex, facing)},
}};

std::array<SolidMesh, kSphereSubdivisions.size() + 2> all_meshes() {
  return {sphere_mesh(kSphereSubdivisions[0]), sphere_mesh(kSphereSubdivisions[1]),
          sphere_mesh(kSphereSubdivisions[2]), box_mesh(), wheel_mesh()};
}

}  // namespace

struct SolidPass::Device {
  explicit Device(const std::filesystem::path& shader_folder) : folder(shader_folder) {}

  GLuint program(std::size_t shape) {
    if (programs[shape].get() == 0) {
      if (shape == layouts::kSolidSphere) {
        programs[shape] = make_program(folder, {"pass/boulder.vert", "pass/boulder.frag"});
        stone = paint_stone_map(folder, kStoneAlbedo);
      } else {
        programs[shape] =
            make_program(folder, {"pass/solid.vert", "pass/solid.frag"}, {kShapeDefines[shape]});
      }
    }
    return programs[shape].get();
  }

  std::filesystem::path folder;
  std::array<GlProgram, kShapeDefines.size()> programs;
  StoneMap stone;
  PackedMeshes meshes{std::span<const SolidMesh>(all_meshes()), kVertexAttributes, "solids"};
};

SolidPass::SolidPass(std::filesystem::path shader_folder) : shader_folder_(std::move(shader_folder)) {}

SolidPass::~SolidPass() = default;

bool SolidPass::prepare(StreamBuffer& stream, std::span<const DrawnSolid> solids, const Camera& camera) {
  batches_.clear();
  triangles_drawn_ = 0;
  if (solids.empty()) return false;
  if (!device_) device_ = std::make_unique<Device>(shader_folder_);
  struct Sorted {
    std::size_t mesh, map_level;
    const DrawnSolid* solid;
  };
  std::vector<Sorted> sorted;
  for (const DrawnSolid& solid : solids) {
    const std::size_t mesh = mesh_of(solid, camera);
    device_->program(shape_of(mesh));  // painting the stones' maps must not come between draws
    const bool is_stone = solid.shape == DrawnSolid::Shape::kSphere;
    sorted.push_back(
        {mesh, is_stone ? device_->stone.level_for(radius_m(solid), pixel_m(solid, camera)) : 0, &solid});
  }
  std::ranges::stable_sort(sorted, {}, [](const Sorted& one) { return std::pair(one.mesh, one.map_level); });
  std::vector<SolidParams> table;
  for (const Sorted& one : sorted) {
    if (batches_.empty() || batches_.back().mesh != one.mesh || batches_.back().map_level != one.map_level)
      batches_.push_back({one.mesh, one.map_level, static_cast<std::uint32_t>(table.size()), 0});
    table.push_back(params_of(*one.solid, camera.eye_m));
    ++batches_.back().count;
  }
  table_ = stream.write(table.data(), table.size() * sizeof(SolidParams));
  return true;
}

void SolidPass::draw() {
  triangles_drawn_ = 0;
  for (const Batch& batch : batches_) {
    const GLuint program = device_->program(shape_of(batch.mesh));
    glUseProgram(program);
    glProgramUniform1ui(program, layouts::kFirstThing, batch.first);
    const bool is_stone = shape_of(batch.mesh) == layouts::kSolidSphere;
    set_draw_state(is_stone ? kStoneState : kState);
    if (is_stone) {
      const StoneMap::Level& level = device_->stone.levels[batch.map_level];
      glBindTextureUnit(layouts::kStoneAlbedoUnit, level.albedo.get());
      glBindTextureUnit(layouts::kStoneSurfaceUnit, level.surface.get());
    }
    bind_storage(layouts::kThingBuffer, table_);
    triangles_drawn_ += device_->meshes.draw(batch.mesh, batch.count);
  }
}

}  // namespace prairie
