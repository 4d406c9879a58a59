// Bindings and work distribution that the planting shaders share: one invocation per blade, workgroups span
// cells.
//
// Cells, species and tables are read through buffer textures: where neighbouring invocations read different
// places, a software renderer fetches four words from a texel in half the time that it takes to load one from
// a storage buffer. For the same reason results are stored by whole texels.
layout(local_size_x = kPlantingGroup) in;

layout(binding = kCellUnit) uniform usamplerBuffer cell_texels;          // DrawnCell
layout(binding = kCellTableUnit) uniform samplerBuffer table_texels;     // the cells' tables
layout(binding = kCellOfGroupUnit) uniform usamplerBuffer group_texels;  // first cell of each workgroup

layout(location = kPlantBladeCount) uniform uint blade_count;

vec4 table_texel(uint texel) {
  return texelFetch(table_texels, int(texel));
}
#include "shaders/lib/kernels.glsl"
#include "shaders/lib/species.glsl"

// A software renderer fetches a cell's features whether it has some or not, so shaders are made with and
// without.
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
  while (index >= texelFetch(cell_texels, cell * kCellTexels + 5).w +
                      texelFetch(cell_texels, cell * kCellTexels + 6).x) {
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
  cell.quarter = g.y;
  cell.first_index = g.z;
  cell.morph = uintBitsToFloat(g.w);
  return cell;
}
