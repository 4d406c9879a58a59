#version 450 core
// Plants and poses the blades of a batch: from the plan's cells to Hermite curves as seen from the eye (docs/design.md, D3).
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"
#include "shaders/pass/planting.glsl"

layout(std430, binding = 4) writeonly buffer PosedBlades { uvec4 posed_texels[]; };  // PosedBlade

uint packed_normal(uint species, vec3 normal) {
  uint x = uint(int((normal.x * 0.5f + 0.5f) * 4095.0f + 0.5f));
  uint y = uint(int((normal.y * 0.5f + 0.5f) * 4095.0f + 0.5f));
  return (species << 24u) | (x << 12u) | y;
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= blade_count) return;
  DrawnCell drawn = load_cell(cell_of(index));
  PlantedCell cell = drawn.planted;
  vec3 eye_from_tile_m = drawn.eye_from_tile_m;
  uint k = index - drawn.first_blade + drawn.first_index;

  SpeciesParams species = load_species(cell.species);
  WarpedRoot root = plant_root(cell, k);
  vec2 local_m = root_in_cell(cell, root);
  GroundPoint ground = ground_in_cell(cell.ground_table, cell.side_m, local_m);
  Features features = planting_features(cell, local_m);

  vec3 root_m = eye_from_tile_m + vec3(cell.offset_m + local_m, ground.height_m);
  float distance_m = sqrt(inner(root_m, root_m));
  vec3 to_eye = frame.parallel > 0.5f ? frame.towards_eye : -root_m / max(distance_m, 1.0e-6f);
  float pixel_m = frame.parallel > 0.5f ? frame.pixel_m : frame.pixel_m * distance_m;
  vec3 normal = normalized(vec3(-ground.slope, 1.0f));
  float keep = keep_share(frame.lod, inner(normal, to_eye), pixel_m, distance_m);
  float rank = (float(int(k)) + cell.rank_offset) / float(int(cell.planted));
  float growth = growth_of(frame.lod, keep, rank);

  Blade blade = grow_blade(cell, species, k, local_m, traits_of(cell.key.y, k), clump_of(cell, species, local_m), features, ground.height_m);
  BladeCurve curve = pose_blade(blade, ground.slope, growth);

  PosedBlade result;
  result.base_m = eye_from_tile_m + curve.base_m;
  result.tip_m = eye_from_tile_m + curve.tip_m;
  result.base_tangent_m = curve.base_tangent_m;
  result.tip_tangent_m = curve.tip_tangent_m;
  result.side = curve.side;
  result.width_m = growth > 0.0f ? widened_m(frame.lod, keep, blade.width_m, pixel_m) : 0.0f;
  result.shade = shade_of(root.density + cell.other_density_per_m2, frame.shade_density_per_m2);
  result.root_color = pack_color(root_albedo(species, blade.hue, blade.dryness) * features.color);
  result.tip_color = pack_color(tip_albedo(species, blade.hue, blade.dryness) * features.color);
  result.species_and_normal = packed_normal(cell.species, normal);
  uint first = uint(kPosedTexels) * index;
  posed_texels[first] = floatBitsToUint(vec4(result.base_m, result.width_m));
  posed_texels[first + 1u] = floatBitsToUint(vec4(result.tip_m, result.shade));
  posed_texels[first + 2u] = uvec4(floatBitsToUint(result.base_tangent_m), result.root_color);
  posed_texels[first + 3u] = uvec4(floatBitsToUint(result.tip_tangent_m), result.tip_color);
  posed_texels[first + 4u] = uvec4(floatBitsToUint(result.side), result.species_and_normal);
}
