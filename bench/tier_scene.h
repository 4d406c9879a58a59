// Level swards of one species, on which tiers are compared: three species, three densities, two lights.
#pragma once

#include <string>
#include <vector>

#include "lod/camera.h"
#include "pictures/picture_metrics.h"
#include "render/frame/renderer.h"
#include "world/world.h"

namespace prairie {

struct TierScene {
  std::string name;
  Scene scene;
  bool is_middle = false;  // of middle density, with the sun behind
};

/// `extent_m`: of the sward.
std::vector<TierScene> tier_scenes(glm::dvec2 extent_m);

/// A camera over the southern border of the sward that looks north along the horizon. Its pixels are those of
/// 600 rows over 60°, for which the tiers' distances are meant, whatever its size.
Camera tier_camera(const TierScene& scene, double eye_height_m, glm::ivec2 size_px);

/// The picture's row, from the top, in which the ground at a distance lies.
int row_of_ground(const Camera& camera, double eye_height_m, double distance_m);

double mean_cover(const Picture& picture, const PixelRect& rect);

}  // namespace prairie
