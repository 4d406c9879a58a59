// What the tables of a sward's look say (lod/sward/sward_response.h), read as a texture unit reads them.
#pragma once

#include "lod/sward/sward_response.h"

namespace prairie {

struct SwardLook {
  glm::vec3 color{0.0f};
  float cover = 0.0f;
};

SwardLook look(const SwardResponse& response, double sin_elevation, double azimuth_to_sun_rad,
               double leaf_area, float shade);
/// The same of one species of the mix; `cover` is its own part. `leaf_area` is that of the whole mix.
SwardLook look_of_layer(const SwardResponse& response, std::size_t layer, double sin_elevation,
                        double azimuth_to_sun_rad, double leaf_area, float shade);

}  // namespace prairie
