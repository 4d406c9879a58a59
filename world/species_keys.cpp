#include "world/species_keys.h"

#include <numbers>

namespace prairie {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kMPerMm = 1e-3;
constexpr Bounds kShare{0.0, 1.0};
// A blade's value lies in mean · (1 ± spread); at 1 the smallest would have no size at all.
constexpr Bounds kSpread{0.0, 0.95};

struct NumberKey {
  const char* key;
  float SpeciesParams::*member;
  Bounds bounds;      // in the key's own unit
  double unit = 1.0;  // of the key, in the member's
};

constexpr NumberKey kNumberKeys[] = {
    {"height_m", &SpeciesParams::height_m, {0.005, 6.0}},
    {"height_spread", &SpeciesParams::height_spread, kSpread},
    {"width_mm", &SpeciesParams::width_m, {0.1, 100.0}, kMPerMm},
    {"width_spread", &SpeciesParams::width_spread, kSpread},
    {"tilt_deg", &SpeciesParams::tilt_rad, {0.0, 85.0}, kRadPerDeg},
    {"lean_deg", &SpeciesParams::lean_rad, {0.0, 85.0}, kRadPerDeg},
    {"curvature_deg", &SpeciesParams::curvature_rad, {0.0, 170.0}, kRadPerDeg},
    {"curvature_spread", &SpeciesParams::curvature_spread, kSpread},
    {"mass_g", &SpeciesParams::mass_g, {1e-4, 1000.0}},
    {"stiffness", &SpeciesParams::stiffness, {0.1, 1e4}},
    {"stiffness_spread", &SpeciesParams::stiffness_spread, kSpread},
    {"clump_m", &SpeciesParams::clump_m, {0.02, 20.0}},
    {"clump_strength", &SpeciesParams::clump_strength, kShare},
    {"clump_spray_deg", &SpeciesParams::clump_spray_rad, {0.0, 85.0}, kRadPerDeg},
    {"dry_share", &SpeciesParams::dry_share, kShare},
    {"dry_spread", &SpeciesParams::dry_spread, kShare},
    {"hue_spread", &SpeciesParams::hue_spread, kShare},
    {"specular", &SpeciesParams::specular, kShare},
};

struct ColorKey {
  const char* key;
  glm::vec3 SpeciesParams::*member;
};

constexpr ColorKey kColorKeys[] = {
    {"root_color", &SpeciesParams::root_color},
    {"tip_color", &SpeciesParams::tip_color},
    {"dry_color", &SpeciesParams::dry_color},
    {"transmission", &SpeciesParams::transmission},
};

}  // namespace

SpeciesParams default_species_params() {
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
  params.tilt_rad = static_cast<float>(12.0 * kRadPerDeg);
  params.lean_rad = static_cast<float>(10.0 * kRadPerDeg);
  params.curvature_rad = static_cast<float>(45.0 * kRadPerDeg);
  params.curvature_spread = 0.5f;
  params.mass_g = 0.06f;
  params.stiffness = 60.0f;
  params.stiffness_spread = 0.3f;
  params.clump_m = 0.28f;
  params.clump_strength = 0.55f;
  params.clump_spray_rad = static_cast<float>(18.0 * kRadPerDeg);
  return params;
}

void read_species_params(TableReader& table, SpeciesParams& params) {
  for (const NumberKey& entry : kNumberKeys) {
    const auto value = table.number(entry.key, entry.bounds);
    if (value) params.*entry.member = static_cast<float>(*value * entry.unit);
  }
  for (const ColorKey& entry : kColorKeys) {
    if (const auto value = table.color(entry.key, kShare)) params.*entry.member = *value;
  }
}

}  // namespace prairie
