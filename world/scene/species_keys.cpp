// [[species]]: what a grass looks like and how it bends.
#include "generator/grasses.h"
#include "world/scene/key_ranges.h"
#include "world/scene/key_table.h"
#include "world/scene/map_text.h"
#include "world/scene/name_key.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

// A blade's value lies in mean · (1 ± spread); at 1 the smallest would have no size at all.
constexpr Bounds kSpread{0.0, 0.95};
constexpr Bounds kDensityPerM2{0.0, kMaxDensityPerM2};
constexpr Bounds kAngleDeg{0.0, 85.0};

// In the text that is hashed colours come before numbers, dryness before form.
constexpr HashLine kDryness{"parameter", 2};
constexpr HashLine kForm{"parameter", 3};

MapSpec default_density(const Scene& scene) {
  MapSpec map = default_map(scene);
  map.max = SpeciesSpec{}.uniform_density_per_m2;
  return map;
}

/// A number or a map.
void read_density(TableReader& table, const KeyTraits& key, const Scene& so_far, SpeciesSpec& species) {
  if (table.holds_table(key.name)) {
    TableReader inner = *table.table(key.name);
    species.density = default_density(so_far);
    read_section(map_keys(MapUse::kDensity), inner, so_far, *species.density);
    return;
  }
  if (table.has(key.name) && !table.holds_number(key.name))
    table.refuse(key.name, "blades per m² or a table { file = \"…\" }");
  read_value(table, key, species.uniform_density_per_m2);
}

void hash_density(CanonicalText& text, const KeyTraits& key, const ContentHashes& files,
                  const SpeciesSpec& species) {
  if (!species.density) return text.add(key.hash.name, species.uniform_density_per_m2);
  hash_map(text, "density", *species.density, MapUse::kDensity, files);
}

std::string density_text(const KeyTraits& key, const Scene& scene, const SpeciesSpec& species) {
  if (!species.density) return value_text(key, species.uniform_density_per_m2);
  return map_text(scene, *species.density, MapUse::kDensity, default_density(scene));
}

template <auto parameter>
Key<SpeciesSpec> parameter_key(std::string_view name, Bounds range, HashLine hash,
                               Unit unit = Unit::kMembers) {
  return key<&SpeciesSpec::species, &Species::params, parameter>(
      {.name = name, .range = range, .unit = unit, .hash = hash});
}

}  // namespace

SpeciesSpec default_species() {
  SpeciesSpec species;
  species.species.params = fescue_params();
  return species;
}

const KeyTable<SpeciesSpec>& species_keys() {
  using P = SpeciesParams;
  static const KeyTable<SpeciesSpec> table{{
      name_key<&Scene::species, &SpeciesSpec::species, &Species::name>("species"),
      {.traits = {.name = "density", .range = kDensityPerM2, .hash = {"density_per_m2"}},
       .read = read_density,
       .hash = hash_density,
       .text = density_text},
      parameter_key<&P::height_m>("height_m", {0.005, 6.0}, kForm),
      parameter_key<&P::height_spread>("height_spread", kSpread, kForm),
      parameter_key<&P::width_m>("width_mm", {0.1, 100.0}, kForm, Unit::kMillimetres),
      parameter_key<&P::width_spread>("width_spread", kSpread, kForm),
      parameter_key<&P::tilt_rad>("tilt_deg", kAngleDeg, kForm, Unit::kDegrees),
      parameter_key<&P::lean_rad>("lean_deg", kAngleDeg, kForm, Unit::kDegrees),
      parameter_key<&P::curvature_rad>("curvature_deg", {0.0, 170.0}, kForm, Unit::kDegrees),
      parameter_key<&P::curvature_spread>("curvature_spread", kSpread, kForm),
      parameter_key<&P::mass_g>("mass_g", {1e-4, 1000.0}, kForm),
      parameter_key<&P::stiffness>("stiffness", {0.1, 1e4}, kForm),
      parameter_key<&P::stiffness_spread>("stiffness_spread", kSpread, kForm),
      parameter_key<&P::clump_m>("clump_m", {0.02, 20.0}, kForm),
      parameter_key<&P::clump_strength>("clump_strength", kShare, kForm),
      parameter_key<&P::clump_spray_rad>("clump_spray_deg", kAngleDeg, kForm, Unit::kDegrees),
      parameter_key<&P::dry_share>("dry_share", kShare, kDryness),
      parameter_key<&P::dry_spread>("dry_spread", kShare, kDryness),
      parameter_key<&P::hue_spread>("hue_spread", kShare, kDryness),
      parameter_key<&P::specular>("specular", kShare, kDryness),
      parameter_key<&P::root_color>("root_color", kShare, {"root_color", 1}),
      parameter_key<&P::tip_color>("tip_color", kShare, {"tip_color", 1}),
      parameter_key<&P::dry_color>("dry_color", kShare, {"dry_color", 1}),
      parameter_key<&P::transmission>("transmission", kShare, {"transmission", 1}),
      key<&SpeciesSpec::motion, &BladeMotionSpec::damping_ratio>(
          {.name = "damping_ratio", .range = Bounds{0.02, 2.0}, .hash = {"damping_ratio", 4}}),
      key<&SpeciesSpec::motion, &BladeMotionSpec::drag_coefficient>(
          {.name = "drag_coefficient", .range = Bounds{0.0, 2.0}, .hash = {"drag_coefficient", 4}}),
  }};
  return table;
}

}  // namespace prairie
