#include "render/light/scene_light.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace prairie {
namespace {

SunSpec sun_at(double azimuth_deg, double elevation_deg) {
  SunSpec sun;
  sun.azimuth_deg = azimuth_deg;
  sun.elevation_deg = elevation_deg;
  return sun;
}

void expect_direction(const SunSpec& sun, glm::vec3 expected) {
  const glm::vec3 direction = scene_light(sun).sun_direction;
  EXPECT_NEAR(glm::distance(direction, expected), 0.0f, 1e-6f)
      << sun.azimuth_deg << ", " << sun.elevation_deg;
}

TEST(SceneLightTest, TheSunStandsWhereItsBearingAndElevationSay) {
  expect_direction(sun_at(0.0, 0.0), {0.0f, 1.0f, 0.0f});
  expect_direction(sun_at(90.0, 0.0), {1.0f, 0.0f, 0.0f});
  expect_direction(sun_at(-90.0, 0.0), {-1.0f, 0.0f, 0.0f});
  expect_direction(sun_at(123.0, 90.0), {0.0f, 0.0f, 1.0f});
}

TEST(SceneLightTest, IsProportionalToItsSources) {
  SunSpec bright = sun_at(150.0, 40.0);
  bright.intensity *= 2.0;
  bright.sky_intensity *= 3.0;
  const LightParams plain = scene_light(sun_at(150.0, 40.0)), light = scene_light(bright);
  EXPECT_EQ(light.sun_radiance, 2.0f * plain.sun_radiance);
  EXPECT_EQ(light.zenith_radiance, 3.0f * plain.zenith_radiance);
  EXPECT_EQ(light.top_ambient, 3.0f * plain.top_ambient);
  EXPECT_EQ(light.exposure, plain.exposure);
}

}  // namespace
}  // namespace prairie
