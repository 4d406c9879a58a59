// Planting: blade k of a cell is a pure function of (world seed, cell, species, k) and of the maps (G03 §3.2;
// docs/design.md, D2). What the seed alone gives (traits) never changes when maps are edited; what tuft and
// maps give changes as little as the root moves.

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

// Mean density of all species in the cell.
float mean_density_per_m2(PlantedCell cell) {
  precise float own = float(int(cell.planted)) / (cell.side_m * cell.side_m);
  return own + cell.other_density_per_m2;
}

// The place of a root, relative to the cell's south-west corner, metres.
vec2 root_in_cell(PlantedCell cell, WarpedRoot root) {
  precise float x = root.patch_xy.x * cell.patch_m;
  precise float y = root.patch_xy.y * cell.patch_m;
  return vec2(x, y);
}

Clump clump_of(PlantedCell cell, SpeciesParams species, vec2 local_m) {
  precise float x = cell.clump_offset.x + local_m.x / species.clump_m;
  precise float y = cell.clump_offset.y + local_m.y / species.clump_m;
  return clump_at(cell.clump_lattice, vec2(x, y), cell.species * 0x9e3779b9u + cell.clump_seed);
}

Blade grow_blade(PlantedCell cell, SpeciesParams species, uint index, vec2 local_m, Traits traits,
                 Clump clump, Features features, float ground_m) {
  float shared_part = species.clump_strength;
  precise float own_height = 2.0f * traits.height - 1.0f;
  precise float own_hue = 2.0f * traits.hue - 1.0f;
  precise float own_dryness = 2.0f * traits.dryness - 1.0f;
  // Tufts are tallest in the middle.
  precise float off_centre = min(clump.outward.x * clump.outward.x + clump.outward.y * clump.outward.y, 1.0f);
  precise float crown = 1.0f - 0.45f * shared_part * off_centre;
  precise float tuft_height = lerp(own_height, 0.5f * own_height + 0.8f * clump.height, shared_part);
  precise float relative_height = max(spread_around(1.0f, species.height_spread, tuft_height), 0.15f);
  precise float combed = species.lean_rad * lerp(0.4f, 1.0f, shared_part);
  precise float own_lean = 0.35f * species.lean_rad;
  precise float lean_x = combed * clump.lean.x + own_lean * (2.0f * traits.lean.x - 1.0f) +
                         species.clump_spray_rad * clump.outward.x;
  precise float lean_y = combed * clump.lean.y + own_lean * (2.0f * traits.lean.y - 1.0f) +
                         species.clump_spray_rad * clump.outward.y;
  precise float root_x = cell.offset_m.x + local_m.x;
  precise float root_y = cell.offset_m.y + local_m.y;
  precise float height_m = species.height_m * relative_height * crown * features.blade_height;
  precise float width_m = spread_around(species.width_m, species.width_spread, 2.0f * traits.width - 1.0f);
  precise float azimuth_rad = 6.2831853f * traits.azimuth;
  precise float tilt_rad = species.tilt_rad * traits.tilt;
  precise float curvature_rad =
      spread_around(species.curvature_rad, species.curvature_spread, 2.0f * traits.curvature - 1.0f) *
      features.bend;
  precise float hue = species.hue_spread * lerp(own_hue, 0.6f * own_hue + 0.8f * clump.hue, shared_part);
  precise float dryness = saturate(
      species.dry_share +
      species.dry_spread * lerp(own_dryness, 0.8f * own_dryness + 0.6f * clump.dryness, shared_part));
  precise float mass_g = species.mass_g * (height_m / species.height_m) * (width_m / species.width_m);

  Blade blade;
  blade.root_m = vec2(root_x, root_y);
  blade.ground_m = ground_m;
  blade.height_m = height_m;
  blade.width_m = width_m;
  blade.azimuth_rad = azimuth_rad;
  blade.tilt_rad = tilt_rad;
  blade.curvature_rad = curvature_rad;
  blade.lean = vec2(lean_x, lean_y);
  blade.hue = hue;
  blade.dryness = dryness;
  blade.stiffness =
      spread_around(species.stiffness, species.stiffness_spread, 2.0f * traits.stiffness - 1.0f);
  blade.mass_g = mass_g;
  precise float phase_rad = 6.2831853f * traits.phase;
  blade.phase_rad = phase_rad;
  uint quarter = uint(cell.offset_m.x > 0.0f) + 2u * uint(cell.offset_m.y > 0.0f);
  blade.identity = (cell.species << 26u) | (quarter << 24u) | index;
  return blade;
}

Blade plant_blade(PlantedCell cell, SpeciesParams species, Features features, WarpedRoot root, uint index) {
  vec2 local_m = root_in_cell(cell, root);
  return grow_blade(cell, species, index, local_m, traits_of(cell.key.y, index),
                    clump_of(cell, species, local_m), features,
                    ground_in_cell(cell.ground_table, cell.side_m, local_m).height_m);
}
