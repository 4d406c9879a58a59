// The species of the field.
layout(binding = kSpeciesUnit) uniform samplerBuffer species_texels;  // SpeciesParams

SpeciesParams load_species(uint index) {
  int first = int(index) * kSpeciesTexels;
  vec4 a = texelFetch(species_texels, first);
  vec4 b = texelFetch(species_texels, first + 1);
  vec4 c = texelFetch(species_texels, first + 2);
  vec4 d = texelFetch(species_texels, first + 3);
  vec4 e = texelFetch(species_texels, first + 4);
  vec4 f = texelFetch(species_texels, first + 5);
  vec4 g = texelFetch(species_texels, first + 6);
  vec4 h = texelFetch(species_texels, first + 7);
  SpeciesParams species;
  species.root_color = a.xyz;
  species.dry_share = a.w;
  species.tip_color = b.xyz;
  species.dry_spread = b.w;
  species.dry_color = c.xyz;
  species.hue_spread = c.w;
  species.transmission = d.xyz;
  species.specular = d.w;
  species.height_m = e.x;
  species.height_spread = e.y;
  species.width_m = e.z;
  species.width_spread = e.w;
  species.tilt_rad = f.x;
  species.lean_rad = f.y;
  species.curvature_rad = f.z;
  species.curvature_spread = f.w;
  species.mass_g = g.x;
  species.stiffness = g.y;
  species.stiffness_spread = g.z;
  species.clump_m = g.w;
  species.clump_strength = h.x;
  species.clump_spray_rad = h.y;
  species.blade_area_m2 = h.z;
  species.densest_per_m2 = h.w;
  return species;
}
