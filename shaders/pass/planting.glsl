// Bindings and work distribution that the planting shaders share: one invocation per blade, workgroups span cells.
//
// Cells, species and tables are read through buffer textures: where neighbouring invocations read different places, a
// software renderer fetches four words from a texel in half the time that it takes to load one from a storage buffer. For the
// same reason results are stored by whole texels.
layout(local_size_x = kPlantingGroup) in;

layout(binding = 0) uniform usamplerBuffer cell_texels;       // DrawnCell
layout(binding = 1) uniform samplerBuffer table_texels;       // the cells' tables
layout(binding = 2) uniform samplerBuffer species_texels;     // SpeciesParams
layout(binding = 3) uniform usamplerBuffer group_texels;      // first cell of each workgroup

layout(location = 0) uniform uint blade_count;

vec4 table_texel(uint texel) { return texelFetch(table_texels, int(texel)); }
#include "shaders/pass/kernels.glsl"

// A software renderer fetches a cell's features whether it has some or not, so shaders are made with and without.
Features planting_features(PlantedCell cell, vec2 local_m) {
#ifdef FEATURE_MAPS
  return features_of(cell, local_m);
#else
  return no_features();
#endif
}

// The cell that blade `index` of the batch belongs to, from its workgroup's first one on.
uint cell_of(uint index) {
  int cell = int(texelFetch(group_texels, int(gl_WorkGroupID.x)).x);
  while (index >= texelFetch(cell_texels, cell * kCellTexels + 5).w + texelFetch(cell_texels, cell * kCellTexels + 6).x) {
    ++cell;
  }
  return uint(cell);
}

DrawnCell load_cell(uint index) {
  int first = int(index) * kCellTexels;
  uvec4 a = texelFetch(cell_texels, first);
  uvec4 b = texelFetch(cell_texels, first + 1);
  uvec4 c = texelFetch(cell_texels, first + 2);
  uvec4 d = texelFetch(cell_texels, first + 3);
  uvec4 e = texelFetch(cell_texels, first + 4);
  uvec4 f = texelFetch(cell_texels, first + 5);
  uvec4 g = texelFetch(cell_texels, first + 6);
  DrawnCell cell;
  cell.planted.key = a.xy;
  cell.planted.species = a.z;
  cell.planted.planted = a.w;
  cell.planted.offset_m = uintBitsToFloat(b.xy);
  cell.planted.patch_m = uintBitsToFloat(b.z);
  cell.planted.patches = b.w;
  cell.planted.clump_lattice = ivec2(c.xy);
  cell.planted.clump_offset = uintBitsToFloat(c.zw);
  cell.planted.ground_table = d.x;
  cell.planted.density_table = d.y;
  cell.planted.feature_table = d.z;
  cell.planted.feature_patches = d.w;
  cell.planted.side_m = uintBitsToFloat(e.x);
  cell.planted.rank_offset = uintBitsToFloat(e.y);
  cell.planted.other_density_per_m2 = uintBitsToFloat(e.z);
  cell.planted.clump_seed = e.w;
  cell.eye_from_tile_m = uintBitsToFloat(f.xyz);
  cell.first_blade = f.w;
  cell.first_index = g.z;
  return cell;
}

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
  return species;
}
