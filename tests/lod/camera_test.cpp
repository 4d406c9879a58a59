// Which way a camera looks, and where points land in its picture.
#include "lod/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace prairie {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_near(glm::dvec3 a, glm::dvec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

glm::dvec3 seen_at(const Camera& camera, glm::dvec3 from_eye_m) {
  const glm::vec4 clip = camera.clip_from_eye() * glm::vec4(glm::vec3(from_eye_m), 1.0f);
  return glm::dvec3(glm::vec3(clip) / clip.w);
}

TEST(CameraTest, YawZeroLooksNorthAndTurnsClockwise) {
  Camera camera;
  expect_near(camera.forward(), {0, 1, 0});
  expect_near(camera.right(), {1, 0, 0});
  expect_near(camera.up(), {0, 0, 1});
  camera.yaw_rad = 0.5 * kPi;
  expect_near(camera.forward(), {1, 0, 0});
  expect_near(camera.right(), {0, -1, 0});
  camera.yaw_rad = kPi;
  expect_near(camera.forward(), {0, -1, 0});
}

TEST(CameraTest, PitchIsPositiveUpwards) {
  Camera camera;
  camera.pitch_rad = 0.5 * kPi;
  expect_near(camera.forward(), {0, 0, 1});
  expect_near(camera.up(), {0, -1, 0});
  camera.pitch_rad = -0.5 * kPi;
  expect_near(camera.forward(), {0, 0, -1});
  expect_near(camera.up(), {0, 1, 0});
}

TEST(CameraTest, AxesAreOrthonormalAndRightHanded) {
  for (double yaw = -4.0; yaw < 4.0; yaw += 0.37) {
    for (double pitch = -1.5; pitch <= 1.5; pitch += 0.3) {
      Camera camera;
      camera.yaw_rad = yaw;
      camera.pitch_rad = pitch;
      EXPECT_NEAR(glm::length(camera.forward()), 1.0, 1e-12);
      expect_near(glm::cross(camera.right(), camera.forward()), camera.up());
    }
  }
}

TEST(CameraTest, PerspectiveReversesDepth) {
  Camera camera;
  camera.yaw_rad = 1.1;
  camera.pitch_rad = -0.4;
  EXPECT_NEAR(seen_at(camera, camera.near_m * camera.forward()).z, 1.0, 1e-5);
  EXPECT_NEAR(seen_at(camera, 1e6 * camera.forward()).z, 0.0, 1e-6);
  double previous = 2.0;
  for (double distance_m = camera.near_m; distance_m < 1e5; distance_m *= 1.3) {
    const glm::dvec3 ndc = seen_at(camera, distance_m * camera.forward());
    EXPECT_LT(ndc.z, previous);
    EXPECT_NEAR(ndc.x, 0.0, 1e-5);
    EXPECT_NEAR(ndc.y, 0.0, 1e-5);
    previous = ndc.z;
  }
}

TEST(CameraTest, FieldOfViewIsVertical) {
  Camera camera;
  camera.fov_rad = kPi / 3.0;
  camera.size_px = {800, 400};
  const glm::dvec3 top = camera.forward() + std::tan(kPi / 6.0) * camera.up();
  EXPECT_NEAR(seen_at(camera, 10.0 * top).y, 1.0, 1e-6);
  const glm::dvec3 side = camera.forward() + 2.0 * std::tan(kPi / 6.0) * camera.right();
  EXPECT_NEAR(seen_at(camera, 10.0 * side).x, 1.0, 1e-6);
}

TEST(CameraTest, PixelSizeIsWhatProjectionMakesOfIt) {
  Camera camera;
  camera.size_px = {640, 480};
  const double distance_m = 7.0;
  const glm::dvec3 place = distance_m * camera.forward();
  const double moved = seen_at(camera, place + camera.pixel_m_at(distance_m) * camera.up()).y;
  EXPECT_NEAR(moved * 240.0, 1.0, 1e-3);
  camera.orthographic_height_m = 24.0;
  EXPECT_DOUBLE_EQ(camera.pixel_m(), 0.05);
  EXPECT_DOUBLE_EQ(camera.pixel_m_at(100.0), 0.05);
  EXPECT_NEAR(seen_at(camera, place + camera.pixel_m() * camera.up()).y * 240.0, 1.0, 1e-4);
}

TEST(CameraTest, ParallelProjectionHasNoPerspective) {
  Camera camera;
  camera.pitch_rad = -0.5 * kPi;
  camera.orthographic_height_m = 10.0;
  camera.size_px = {300, 100};
  for (const double depth_m : {0.0, 10.0, 1000.0}) {
    const glm::dvec3 ndc =
        seen_at(camera, depth_m * camera.forward() + 5.0 * camera.up() + 7.5 * camera.right());
    EXPECT_NEAR(ndc.y, 1.0, 1e-5);
    EXPECT_NEAR(ndc.x, 0.5, 1e-5);
    EXPECT_NEAR(ndc.z, 1.0 - depth_m / camera.orthographic_depth_m, 1e-6);
  }
}

}  // namespace
}  // namespace prairie
