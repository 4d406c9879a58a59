#include "generator/grasses.h"

#include <numbers>

#include "pictures/srgb.h"

namespace prairie {
namespace {

float rad_from_deg(double deg) {
  return static_cast<float>(deg * (std::numbers::pi / 180.0));
}

glm::vec3 linear_from_srgb8(int red, int green, int blue) {
  const auto linear = [](int byte) { return static_cast<float>(linear_from_srgb(byte / 255.0)); };
  return {linear(red), linear(green), linear(blue)};
}

}  // namespace

SpeciesParams fescue_params() {
  SpeciesParams params{};
  params.root_color = {0.040f, 0.068f, 0.016f};
  params.tip_color = {0.190f, 0.258f, 0.066f};
  params.dry_color = {0.380f, 0.300f, 0.130f};
  params.transmission = {0.62f, 0.78f, 0.16f};
  params.dry_share = 0.16f;
  params.dry_spread = 0.30f;
  params.hue_spread = 0.5f;
  params.specular = 0.06f;
  params.height_m = 0.32f;
  params.height_spread = 0.35f;
  params.width_m = 0.0035f;
  params.width_spread = 0.30f;
  params.tilt_rad = rad_from_deg(12.0);
  params.lean_rad = rad_from_deg(10.0);
  params.curvature_rad = rad_from_deg(45.0);
  params.curvature_spread = 0.5f;
  params.mass_g = 0.06f;
  params.stiffness = 60.0f;
  params.stiffness_spread = 0.3f;
  params.clump_m = 0.28f;
  params.clump_strength = 0.55f;
  params.clump_spray_rad = rad_from_deg(18.0);
  return params;
}

SpeciesParams oatgrass_params() {
  SpeciesParams params = fescue_params();
  params.root_color = linear_from_srgb8(0x4d, 0x55, 0x26);
  params.tip_color = linear_from_srgb8(0xb5, 0x9a, 0x55);
  params.dry_color = linear_from_srgb8(0xd8, 0xbf, 0x82);
  params.transmission = {0.66f, 0.56f, 0.22f};
  params.dry_share = 0.45f;
  params.dry_spread = 0.35f;
  params.hue_spread = 0.35f;
  params.height_m = 0.72f;
  params.height_spread = 0.25f;
  params.width_m = 0.003f;
  params.width_spread = 0.25f;
  params.tilt_rad = rad_from_deg(9.0);
  params.lean_rad = rad_from_deg(14.0);
  params.curvature_rad = rad_from_deg(34.0);
  params.mass_g = 0.12f;
  params.stiffness = 40.0f;
  params.clump_m = 0.45f;
  params.clump_strength = 0.65f;
  params.clump_spray_rad = rad_from_deg(12.0);
  return params;
}

}  // namespace prairie
