#version 450 core
// Plants blades and stores them as they are: what the CPU's plant_cell writes, for tests and measurements.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/planting.glsl"
#include "shaders/pass/kernels.glsl"

layout(std430, binding = 4) writeonly buffer Blades { Blade blades[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= blade_count) return;
  uint c = cell_of(index);
  PlantedCell cell = cells[c].planted;
  uint k = index - cells[c].first_blade;
  blades[index] = plant_blade(cell, species_table[cell.species], plant_root(cell, k), k);
}
