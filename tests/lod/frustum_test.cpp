// Culling: a box of which any point is seen is never culled, and one that is said to be inside is.
#include "lod/frustum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

namespace prairie {
namespace {

/// By the projection itself, not by planes.
bool sees(const Camera& camera, glm::dvec3 point_m) {
  const glm::vec4 clip = camera.clip_from_eye() * glm::vec4(glm::vec3(point_m - camera.eye_m), 1.0f);
  const float edge = clip.w * (1.0f - 1e-5f);
  return clip.w > 0.0f && std::abs(clip.x) < edge && std::abs(clip.y) < edge && clip.z < edge;
}

Camera random_camera(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Camera camera;
  camera.eye_m = 10.0 * glm::dvec3(unit(random), unit(random), unit(random));
  camera.yaw_rad = 3.2 * unit(random);
  camera.pitch_rad = 1.57 * unit(random);
  camera.fov_rad = 0.3 + 0.8 * (1.0 + unit(random));
  camera.size_px = {200 + static_cast<int>(400.0 * (1.0 + unit(random))), 400};
  if (unit(random) > 0.4) camera.orthographic_height_m = 2.0 + 10.0 * (1.0 + unit(random));
  return camera;
}

TEST(FrustumTest, BoxesWithASeenPointAreKept) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int seen_boxes = 0, culled = 0;
  for (int n = 0; n < 20000; ++n) {
    const Camera camera = random_camera(random);
    const Frustum frustum(camera);
    const glm::dvec3 corner = 25.0 * glm::dvec3(unit(random), unit(random), unit(random));
    const AlignedBox box{corner, corner + 4.0 * (1.0 + glm::dvec3(unit(random), unit(random), unit(random)))};
    bool any = false;
    for (int point = 0; point < 64; ++point) {
      const glm::dvec3 share = 0.5 + 0.5 * glm::dvec3(unit(random), unit(random), unit(random));
      // Corners, edges and faces as well as the inside.
      const glm::dvec3 place = point < 32 ? glm::round(share) : share;
      any |= sees(camera, glm::mix(box.min_m, box.max_m, place));
    }
    seen_boxes += any;
    ASSERT_TRUE(!any || frustum.may_see(box));
    culled += !frustum.may_see(box);
  }
  EXPECT_GT(seen_boxes, 1000);
  EXPECT_GT(culled, 5000);
}

TEST(FrustumTest, DistancesToABox) {
  const AlignedBox box{{0, 0, 0}, {2, 3, 4}};
  EXPECT_DOUBLE_EQ(nearest_distance_m(box, {1, 1, 1}), 0.0);
  EXPECT_DOUBLE_EQ(nearest_distance_m(box, {5, 7, 4}), 5.0);
}

}  // namespace
}  // namespace prairie
