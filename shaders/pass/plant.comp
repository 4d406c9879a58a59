#version 450 core
// Plants blades and stores them as they are: what the CPU's plant_cell writes, for tests and measurements.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/planting.glsl"

layout(std430, binding = kResultBuffer) writeonly buffer Blades {
  uvec4 blade_texels[];
};  // Blade

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= blade_count) return;
  DrawnCell drawn = load_cell(cell_of(index));
  PlantedCell cell = drawn.planted;
  uint k = index - drawn.first_blade + drawn.first_index;
  WarpedRoot root = plant_root(cell, k);
  Blade blade = plant_blade(cell, load_species(cell.species),
                            planting_features(cell, root_in_cell(cell, root)), root, k);
  uint first = uint(kBladeTexels) * index;
  blade_texels[first] = floatBitsToUint(vec4(blade.root_m, blade.ground_m, blade.height_m));
  blade_texels[first + 1u] =
      floatBitsToUint(vec4(blade.width_m, blade.azimuth_rad, blade.tilt_rad, blade.curvature_rad));
  blade_texels[first + 2u] = floatBitsToUint(vec4(blade.lean, blade.hue, blade.dryness));
  blade_texels[first + 3u] =
      uvec4(floatBitsToUint(vec3(blade.stiffness, blade.mass_g, blade.phase_rad)), blade.identity);
}
