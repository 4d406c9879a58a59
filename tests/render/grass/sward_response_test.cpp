// What a sward is predicted to look like from afar, against what one sees of planted blades: ray by ray
// (tests/render/grass/sward_picture.h) and in the renderer's picture of all blades.
#include "lod/sward/sward_response.h"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "render/frame/renderer.h"
#include "render/light/scene_light.h"
#include "shaders/kernels/kernels.h"
#include "tests/render/grass/sward_look.h"
#include "tests/render/grass/sward_picture.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

// The grasses of examples/meadow, and a short broad one.
SpeciesParams fescue() {
  SpeciesParams p{};
  p.root_color = {0.040f, 0.068f, 0.016f};
  p.tip_color = {0.190f, 0.258f, 0.066f};
  p.dry_color = {0.380f, 0.300f, 0.130f};
  p.transmission = {0.62f, 0.78f, 0.16f};
  p.dry_share = 0.16f;
  p.dry_spread = 0.30f;
  p.hue_spread = 0.5f;
  p.specular = 0.06f;
  p.height_m = 0.32f;
  p.height_spread = 0.35f;
  p.width_m = 0.0035f;
  p.width_spread = 0.30f;
  p.tilt_rad = glm::radians(12.0f);
  p.lean_rad = glm::radians(10.0f);
  p.curvature_rad = glm::radians(45.0f);
  p.curvature_spread = 0.5f;
  p.mass_g = 0.06f;
  p.stiffness = 60.0f;
  p.stiffness_spread = 0.3f;
  p.clump_m = 0.28f;
  p.clump_strength = 0.55f;
  p.clump_spray_rad = glm::radians(18.0f);
  return p;
}

SpeciesParams oatgrass() {
  SpeciesParams p = fescue();
  p.root_color = {0.074f, 0.091f, 0.019f};
  p.tip_color = {0.462f, 0.323f, 0.091f};
  p.dry_color = {0.686f, 0.521f, 0.223f};
  p.transmission = {0.66f, 0.56f, 0.22f};
  p.dry_share = 0.45f;
  p.dry_spread = 0.35f;
  p.hue_spread = 0.35f;
  p.height_m = 0.72f;
  p.height_spread = 0.25f;
  p.width_m = 0.003f;
  p.width_spread = 0.25f;
  p.tilt_rad = glm::radians(9.0f);
  p.lean_rad = glm::radians(14.0f);
  p.curvature_rad = glm::radians(34.0f);
  p.mass_g = 0.12f;
  p.stiffness = 40.0f;
  p.clump_m = 0.45f;
  p.clump_strength = 0.65f;
  p.clump_spray_rad = glm::radians(12.0f);
  return p;
}

SpeciesParams short_broad_grass() {
  SpeciesParams p = fescue();
  p.height_m = 0.14f;
  p.width_m = 0.007f;
  p.tilt_rad = glm::radians(35.0f);
  p.curvature_rad = glm::radians(80.0f);
  p.clump_m = 0.2f;
  p.clump_strength = 0.8f;
  p.clump_spray_rad = glm::radians(30.0f);
  return p;
}

LightParams light_from(double sun_elevation_rad, double sun_azimuth_rad) {
  LightParams light{};
  light.sun_direction = glm::vec3(glm::dvec3(std::cos(sun_elevation_rad) * std::cos(sun_azimuth_rad),
                                             std::cos(sun_elevation_rad) * std::sin(sun_azimuth_rad),
                                             std::sin(sun_elevation_rad)));
  light.sun_radiance = {3.2f, 2.98f, 2.56f};
  light.top_ambient = {0.50f, 0.60f, 0.72f};
  light.root_ambient = {0.15f, 0.18f, 0.09f};
  light.horizon_radiance = {0.74f, 0.82f, 0.90f};
  light.shade_density_per_m2 = 1100.0f;
  return light;
}

constexpr std::array<double, 2> kSunElevations = {15.0 * kRadPerDeg, 50.0 * kRadPerDeg};
constexpr std::array<double, 3> kSunAzimuths = {0.0, 0.5 * std::numbers::pi, std::numbers::pi};

double leaf_area(const SwardResponse& response, std::span<const SwardLayer> layers) {
  double sum = 0.0;
  for (std::size_t n = 0; n < layers.size(); ++n)
    sum += layers[n].density_per_m2 * response.layers[n].blade_area_m2;
  return sum;
}

double largest_difference(glm::vec3 predicted, glm::vec3 seen) {
  double largest = 0.0;
  for (int channel = 0; channel < 3; ++channel)
    largest = std::max(largest, std::abs(static_cast<double>(predicted[channel] / seen[channel]) - 1.0));
  return largest;
}

/// Differences over densities, elevations and suns.
struct Differences {
  double color = 0.0;
  double cover = 0.0;
  double mean_color = 0.0;
  int count = 0;
};

Differences differences(std::vector<SwardLayer> layers, std::span<const double> densities_per_m2,
                        std::span<const double> elevations_deg) {
  const std::array<SwardResponse, 2> responses = {sward_response(layers, light_from(kSunElevations[0], 0.0)),
                                                  sward_response(layers, light_from(kSunElevations[1], 0.0))};
  double total = 0.0;
  for (const SwardLayer& layer : layers) total += layer.density_per_m2;
  Differences worst;
  for (const double density : densities_per_m2) {
    std::vector<SwardLayer> sown = layers;
    for (SwardLayer& layer : sown) layer.density_per_m2 *= density / total;
    const double side_m = density < 300.0 ? 16.0 : 8.0;
    const float shade = Kernels{}.shade_of(static_cast<float>(density), 1100.0f);
    for (const double elevation_deg : elevations_deg) {
      const double sine = std::sin(elevation_deg * kRadPerDeg);
      const SwardPicture picture = picture_of(sown, side_m, sine, side_m / 1600.0);
      double color = 0.0;
      double cover = 0.0;
      for (std::size_t s = 0; s < responses.size(); ++s) {
        const double area = leaf_area(responses[s], sown);
        for (const double azimuth : kSunAzimuths) {
          const SwardLook predicted = look(responses[s], sine, azimuth, area, shade);
          const double off = largest_difference(predicted.color,
                                                picture.color(light_from(kSunElevations[s], azimuth), shade));
          color = std::max(color, off);
          cover = static_cast<double>(predicted.cover) - picture.cover();
          worst.mean_color += off;
          ++worst.count;
        }
      }
      std::printf("%5.0f per m2 from %2.0f deg: cover %.3f %+.3f, colour off by %.1f %%\n", density,
                  elevation_deg, picture.cover(), cover, 100.0 * color);
      worst.color = std::max(worst.color, color);
      worst.cover = std::max(worst.cover, std::abs(cover));
    }
  }
  worst.mean_color /= worst.count;
  std::printf("colour off by %.1f %% at most, %.1f %% on average, cover by %.3f\n", 100.0 * worst.color,
              100.0 * worst.mean_color, worst.cover);
  return worst;
}

constexpr std::array<double, 3> kDensities = {100.0, 600.0, 2500.0};
constexpr std::array<double, 6> kElevations = {1.0, 3.0, 10.0, 30.0, 60.0, 90.0};

void expect_near(const Differences& found) {
  EXPECT_LT(found.color, 0.05);
  EXPECT_LT(found.mean_color, 0.025);
  EXPECT_LT(found.cover, 0.03);
}

TEST(SwardResponseTest, TellsWhatOneSeesOfFescue) {
  const SpeciesParams grass = fescue();
  expect_near(differences({{&grass, 1.0}}, kDensities, kElevations));
}

constexpr std::array<double, 2> kSomeDensities = {600.0, 2500.0};
constexpr std::array<double, 4> kSomeElevations = {1.0, 10.0, 30.0, 90.0};

TEST(SwardResponseTest, TellsWhatOneSeesOfOatgrass) {
  const SpeciesParams grass = oatgrass();
  expect_near(differences({{&grass, 1.0}}, kSomeDensities, kSomeElevations));
}

TEST(SwardResponseTest, TellsWhatOneSeesOfShortBroadGrass) {
  const SpeciesParams grass = short_broad_grass();
  expect_near(differences({{&grass, 1.0}}, kSomeDensities, kSomeElevations));
}

TEST(SwardResponseTest, TellsWhatOneSeesOfAMix) {
  const SpeciesParams low = fescue();
  const SpeciesParams tall = oatgrass();
  expect_near(differences({{&low, 0.8}, {&tall, 0.2}}, kSomeDensities, kSomeElevations));
}

TEST(SwardResponseTest, TellsTheSpeciesOfAMixApart) {
  const SpeciesParams low = fescue();
  const SpeciesParams tall = oatgrass();
  const std::vector<SwardLayer> layers = {{&low, 800.0}, {&tall, 200.0}};
  const LightParams light = light_from(kSunElevations[1], kSunAzimuths[1]);
  const SwardResponse response = sward_response(layers, light);
  for (const double elevation_deg : {5.0, 20.0, 70.0}) {
    const double sine = std::sin(elevation_deg * kRadPerDeg);
    const SwardPicture picture = picture_of(layers, 8.0, sine, 0.005);
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      const SwardLook predicted =
          look_of_layer(response, layer, sine, kSunAzimuths[1], leaf_area(response, layers), 0.5f);
      const int of = static_cast<int>(layer);
      EXPECT_NEAR(static_cast<double>(predicted.cover), picture.cover_of(of), 0.03) << elevation_deg;
      EXPECT_LT(largest_difference(predicted.color, picture.color(light, 0.5f, of)), 0.06) << elevation_deg;
    }
  }
}

TEST(SwardResponseTest, KnowsASpeciesThatIsSownNowhere) {
  const SpeciesParams low = fescue();
  const SpeciesParams tall = oatgrass();
  const LightParams light = light_from(kSunElevations[0], 0.0);
  const std::vector<SwardLayer> layers = {{&low, 500.0}, {&tall, 0.0}};
  const SwardResponse mixed = sward_response(layers, light);
  const SwardResponse alone = sward_response(std::span(layers).first(1), light);
  for (std::size_t n = 0; n < alone.colors.free.size(); ++n) {
    EXPECT_NEAR(mixed.colors.free[n].y, alone.colors.free[n].y, 0.01f * alone.colors.free[n].y);
    EXPECT_GT(mixed.layers[1].colors.free[n].y, 0.0f);
    EXPECT_EQ(mixed.layers[1].colors.free[n].w, 0.0f);
  }
}

TEST(SwardResponseTest, IsTheSameOnAnyNumberOfThreads) {
  const SpeciesParams low = fescue();
  const SpeciesParams tall = oatgrass();
  const SpeciesParams broad = short_broad_grass();
  const std::vector<SwardLayer> layers = {{&low, 800.0}, {&tall, 200.0}, {&broad, 100.0}};
  const LightParams light = light_from(kSunElevations[0], 0.0);
  const auto timed = [&] {
    const auto start = std::chrono::steady_clock::now();
    SwardResponse response = sward_response(layers, light);
    std::printf("%.1f ms\n",
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    return response;
  };
  const SwardResponse many = timed();
  const oneapi::tbb::global_control one_thread(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const SwardResponse one = timed();
  EXPECT_EQ(many.projected, one.projected);
  EXPECT_EQ(many.colors.free, one.colors.free);
  EXPECT_EQ(many.layers[2].colors.shaded, one.layers[2].colors.shaded);
}

class SwardRenderTest : public HeadlessTest {};

/// Dense enough that no floor shows, in a parallel projection.
TEST_F(SwardRenderTest, HasTheColorOfThePictureOfAllBlades) {
  Scene scene;
  scene.extent_m = glm::dvec2(32.0);
  scene.sun.azimuth_deg = 240.0;
  scene.sun.elevation_deg = 35.0;
  scene.species.resize(1);
  scene.species[0].species.name = "fescue";
  scene.species[0].species.params = fescue();
  scene.species[0].uniform_density_per_m2 = 2500.0;
  const World world = open_world(scene);
  const LightParams light = scene_light(scene.sun);
  const SwardLayer layer{&scene.species[0].species.params, 2500.0};
  const SwardResponse response = sward_response(std::span(&layer, 1), light);
  const float shade = Kernels{}.shade_of(2500.0f, light.shade_density_per_m2);
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);

  FrameOptions all_blades;
  all_blades.tier = Tier::kHermite;
  for (const double pitch_deg : {-4.0, -12.0}) {
    Camera camera;
    camera.yaw_rad = 0.0;
    camera.pitch_rad = pitch_deg * kRadPerDeg;
    camera.size_px = {700, 300};
    camera.orthographic_height_m = 1.2;
    camera.eye_m = glm::dvec3(16.0, 16.0, 0.2) - 30.0 * camera.forward();
    const Picture picture = renderer.render(camera, all_blades, 4);
    glm::dvec3 sum(0.0);
    for (std::size_t n = 0; n < picture.linear_rgb.size(); ++n)
      sum[static_cast<int>(n % 3)] += static_cast<double>(picture.linear_rgb[n]);
    const glm::vec3 seen(sum / (static_cast<double>(picture.linear_rgb.size()) / 3.0));
    const SwardLook predicted =
        look(response, -std::sin(camera.pitch_rad), (scene.sun.azimuth_deg - 180.0) * kRadPerDeg,
             leaf_area(response, std::span(&layer, 1)), shade);
    std::printf("seen %.4f %.4f %.4f, predicted %.4f %.4f %.4f\n", static_cast<double>(seen.x),
                static_cast<double>(seen.y), static_cast<double>(seen.z),
                static_cast<double>(predicted.color.x), static_cast<double>(predicted.color.y),
                static_cast<double>(predicted.color.z));
    EXPECT_GT(predicted.cover, 0.995f);
    EXPECT_LT(largest_difference(predicted.color, seen), 0.05) << pitch_deg;
  }
}

}  // namespace
}  // namespace prairie
