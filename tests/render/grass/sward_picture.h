// What one really sees of planted blades from afar, found without OpenGL and without the assumption that leaf
// area stands at random: a patch of a field that repeats, looked at by parallel rays a few millimetres apart.
// The blades are posed, widened and lit as the shaders do it.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "lod/sward/sward_response.h"

namespace prairie {

struct SwardPicture {
  struct BladeSeen {
    Blade blade;
    std::size_t layer;
    std::vector<float> vertex_rays;  // how many rays end at it, shared out to its vertices
  };
  double rays = 0.0;
  double rays_on_blades = 0.0;
  glm::vec3 to_eye{0.0f, 0.0f, 1.0f};
  std::vector<const SpeciesParams*> species;
  std::vector<BladeSeen> blades;

  double cover() const { return rays_on_blades / rays; }
  /// Mean radiance of the blades that are seen; of one layer's, if it is not negative.
  glm::vec3 color(const LightParams& light, float shade, int layer = -1) const;
  double cover_of(int layer) const;
};

/// Plants `side_m` × `side_m` of level ground, and looks at it from azimuth 0 (east). Rays lie `ray_m` apart.
SwardPicture picture_of(std::span<const SwardLayer> layers, double side_m, double sin_elevation, double ray_m,
                        int segments = 16, std::uint64_t seed = 3);

}  // namespace prairie
