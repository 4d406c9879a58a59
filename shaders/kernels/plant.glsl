// Planting: blade k of a cell is a pure function of (world seed, cell, species, k) and of the maps (G03 §3.2;
// docs/design.md, D2). What the seed alone gives (traits) never changes when maps are edited; what tuft and maps give
// changes as little as the root moves.

// A blade's own numbers, each in [0, 1).
struct Traits {
  float height;
  float width;
  float azimuth;
  float tilt;
  float curvature;
  float hue;
  float dryness;
  float stiffness;
  float phase;
  vec2 lean;
};

Traits traits_of(uint key, uint index) {
  uvec3 a = hash_uvec3(uvec3(index, key, 0x51ed270bu));
  uvec3 b = hash_uvec3(uvec3(a.x, a.y ^ index, a.z));
  Traits traits;
  traits.height = unit_from_high16(a.x);
  traits.width = unit_from_low16(a.x);
  traits.azimuth = unit_from_high16(a.y);
  traits.tilt = unit_from_low16(a.y);
  traits.curvature = unit_from_high16(a.z);
  traits.hue = unit_from_low16(a.z);
  traits.dryness = unit_from_high16(b.x);
  traits.stiffness = unit_from_low16(b.x);
  traits.phase = unit_from_high16(b.y);
  traits.lean = vec2(unit_from_high16(b.z), unit_from_low16(b.z));
  return traits;
}

// mean · (1 ± spread), from a number in [−1, 1].
float spread_around(float mean, float spread, float signed_unit) {
  precise float result = mean * (1.0f + spread * signed_unit);
  return result;
}

WarpedRoot plant_root(PlantedCell cell, uint index) {
  return warp_to_density(cell.density_table, cell.patches, sequence_point(index, cell.key.x));
}

Blade plant_blade(PlantedCell cell, SpeciesParams species, WarpedRoot root, uint index) {
  precise vec2 local_m = root.patch_xy * cell.patch_m;
  Traits traits = traits_of(cell.key.y, index);
  precise vec2 clump_offset = cell.clump_offset + local_m / species.clump_m;
  Clump clump = clump_at(cell.clump_lattice, clump_offset, cell.species * 0x9e3779b9u + 0x7f4a7c15u);
  Features features = features_in_cell(cell.feature_table, cell.feature_patches, cell.side_m, local_m);
  float shared_part = species.clump_strength;

  Blade blade;
  blade.root_m = cell.offset_m + local_m;
  blade.ground_m = ground_in_cell(cell.ground_table, cell.side_m, local_m).height_m;
  precise float own_height = 2.0f * traits.height - 1.0f;
  // Tufts are tallest in the middle.
  precise float crown = 1.0f - 0.45f * shared_part * min(clump.outward.x * clump.outward.x + clump.outward.y * clump.outward.y, 1.0f);
  precise float relative = spread_around(1.0f, species.height_spread, lerp(own_height, 0.5f * own_height + 0.8f * clump.height, shared_part));
  blade.height_m = species.height_m * max(relative, 0.15f) * crown * features.blade_height;
  blade.width_m = spread_around(species.width_m, species.width_spread, 2.0f * traits.width - 1.0f);
  precise float azimuth = 6.2831853f * traits.azimuth;
  blade.azimuth_rad = azimuth;
  blade.tilt_rad = species.tilt_rad * traits.tilt;
  blade.curvature_rad = spread_around(species.curvature_rad, species.curvature_spread, 2.0f * traits.curvature - 1.0f) * features.bend;
  blade.lean = species.lean_rad * lerp(0.4f, 1.0f, shared_part) * clump.lean +
               0.35f * species.lean_rad * (2.0f * traits.lean - vec2(1.0f, 1.0f)) + species.clump_spray_rad * clump.outward;
  blade.hue = species.hue_spread * lerp(2.0f * traits.hue - 1.0f, 0.6f * (2.0f * traits.hue - 1.0f) + 0.8f * clump.hue, shared_part);
  blade.dryness = saturate(species.dry_share + species.dry_spread * lerp(2.0f * traits.dryness - 1.0f, 0.8f * (2.0f * traits.dryness - 1.0f) + 0.6f * clump.dryness, shared_part));
  blade.stiffness = spread_around(species.stiffness, species.stiffness_spread, 2.0f * traits.stiffness - 1.0f);
  blade.mass_g = species.mass_g * (blade.height_m / species.height_m) * (blade.width_m / species.width_m);
  blade.phase_rad = 6.2831853f * traits.phase;
  blade.identity = (cell.species << 24u) | index;
  return blade;
}
