// Draws what stands in the meadow: trunks, blocks, rocks and walls (render/things/shapes/obstacle_mesh.h,
// render/things/shapes/wall_mesh.h). It does not move, so that it is handed to the device once, in squares
// with an origin each, so that places are precise however far from the scene's origin; squares out of sight
// are left out, and trunks in far ones have fewer sides. A frame where nothing stands costs nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "agents/obstacle.h"
#include "lod/camera.h"
#include "render/gl/draw_state.h"

namespace prairie {

class ObstaclePass {
 public:
  /// What stands is closed above the ground.
  static constexpr DrawState kState{.culls_backs = true};

  explicit ObstaclePass(std::filesystem::path shader_folder);
  ~ObstaclePass();
  ObstaclePass(const ObstaclePass&) = delete;
  ObstaclePass& operator=(const ObstaclePass&) = delete;

  /// From now on these stand on that ground. Throws NoSuitableOpenGl, BadInput where shaders cannot be made,
  /// and BadInput on an outline that convex_pieces() refuses; what stood before then still does.
  void set(const StandingThings& things, const HeightField& ground);
  /// Finds what a frame sees, nearest first; whether there is anything.
  bool prepare(const Camera& camera);
  /// Draws it; the frame's blocks must be bound.
  void draw();
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  struct Device;
  struct Seen {
    double distance_m = 0.0;
    std::size_t square = 0;
    bool is_far = false;  // trunks are then of fewer sides
    glm::vec3 origin_from_eye_m{0.0f};
  };

  std::filesystem::path shader_folder_;
  std::unique_ptr<Device> device_;  // none while nothing stands
  std::vector<Seen> seen_;
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace prairie
