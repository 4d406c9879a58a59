// Draws solid things that stand among the grass: boulders, boxes of boards, wheels. One draw call a mesh and
// level of detail; a frame without solids costs nothing, and the shaders are compiled when the first one is
// seen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lod/camera.h"
#include "render/gl/draw_state.h"
#include "render/gl/stream_buffer.h"

namespace prairie {

struct DrawnSolid {
  enum class Shape {
    kSphere,  // an ellipsoid where its half sizes differ
    kBox,     // of boards
    kWheel    // its axle along the second axis
  };
  Shape shape = Shape::kSphere;
  glm::dvec3 centre_m{0.0};
  glm::mat3 axes{1.0f};         // unit columns, in the scene: forward, left, up
  glm::vec3 half_size_m{1.0f};  // along them
  glm::vec3 albedo{0.5f};       // linear
  float roughness_of_outline =
      0.0f;  // of a sphere: greatest depth of its dents over its radius; with any it is of stone
  float above_ground_m = 0.0f;  // of its lowest point: the sward around darkens what is near the ground
  std::uint32_t seed = 0;       // tells stones and boards apart
};

class SolidPass {
 public:
  static constexpr DrawState kState{};

  explicit SolidPass(std::filesystem::path shader_folder);
  ~SolidPass();
  SolidPass(const SolidPass&) = delete;
  SolidPass& operator=(const SolidPass&) = delete;

  /// Hands a frame's solids to the device; whether there are any. Throws NoSuitableOpenGl, BadInput where
  /// shaders cannot be made.
  bool prepare(StreamBuffer& stream, std::span<const DrawnSolid> solids, const Camera& camera);
  /// Draws them; the frame's blocks must be bound.
  void draw();
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  static constexpr DrawState kStoneState{.culls_backs = true};  // the only closed ones
  struct Device;
  /// Solids of one mesh, and stones of one level of their map.
  struct Batch {
    std::size_t mesh, map_level;
    std::uint32_t first, count;
  };

  std::filesystem::path shader_folder_;
  std::unique_ptr<Device> device_;  // none until there is something to draw
  std::vector<Batch> batches_;
  StreamBuffer::Slice table_;
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace prairie
