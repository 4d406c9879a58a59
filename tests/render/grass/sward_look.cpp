#include "tests/render/grass/sward_look.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

namespace prairie {
namespace {

// A coordinate's nodes and how far it lies towards the second one.
struct Between {
  int first, second;
  float share;
};

Between between(float coordinate, int nodes) {
  const float at = coordinate * static_cast<float>(nodes - 1);
  const int first = std::min(static_cast<int>(at), nodes - 1);
  return {first, std::min(first + 1, nodes - 1), at - static_cast<float>(first)};
}

glm::vec4 read(const std::vector<glm::vec4>& table, glm::vec3 place) {
  const Between x = between(place.x, SwardResponse::kElevations);
  const Between y = between(place.y, SwardResponse::kAzimuths);
  const Between z = between(place.z, SwardResponse::kDepths);
  const auto row = [&](int depth, int azimuth) {
    const auto begin =
        static_cast<std::size_t>((depth * SwardResponse::kAzimuths + azimuth) * SwardResponse::kElevations);
    return glm::mix(table[begin + static_cast<std::size_t>(x.first)],
                    table[begin + static_cast<std::size_t>(x.second)], x.share);
  };
  return glm::mix(glm::mix(row(z.first, y.first), row(z.first, y.second), y.share),
                  glm::mix(row(z.second, y.first), row(z.second, y.second), y.share), z.share);
}

double depth_of(const SwardResponse& response, double sin_elevation, double leaf_area) {
  const Between x = between(sward_place(sin_elevation, 0.0, 0.0).x, SwardResponse::kElevations);
  const float projected = glm::mix(response.projected[static_cast<std::size_t>(x.first)],
                                   response.projected[static_cast<std::size_t>(x.second)], x.share);
  return leaf_area * static_cast<double>(projected) /
         std::max(sin_elevation, static_cast<double>(kSwardLowestSine));
}

}  // namespace

SwardLook look(const SwardResponse& response, double sin_elevation, double azimuth_to_sun_rad,
               double leaf_area, float shade) {
  const double depth = depth_of(response, sin_elevation, leaf_area);
  const glm::vec3 place = sward_place(sin_elevation, azimuth_to_sun_rad, depth);
  const glm::vec4 color =
      glm::mix(read(response.colors.free, place), read(response.colors.shaded, place), shade);
  return {glm::vec3(color), static_cast<float>(-std::expm1(-depth))};
}

SwardLook look_of_layer(const SwardResponse& response, std::size_t layer, double sin_elevation,
                        double azimuth_to_sun_rad, double leaf_area, float shade) {
  const double depth = depth_of(response, sin_elevation, leaf_area);
  const glm::vec3 place = sward_place(sin_elevation, azimuth_to_sun_rad, depth);
  const SwardResponse::Colors& colors = response.layers[layer].colors;
  const glm::vec4 color = glm::mix(read(colors.free, place), read(colors.shaded, place), shade);
  return {glm::vec3(color), color.w * static_cast<float>(-std::expm1(-depth))};
}

}  // namespace prairie
