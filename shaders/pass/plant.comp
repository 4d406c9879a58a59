#version 450 core
// Plants blades and stores them as they are: what the CPU's plant_cell writes, for tests and measurements.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/planting.glsl"

layout(std430, binding = 4) writeonly buffer Blades { Blade blades[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= blade_count) return;
  DrawnCell drawn = load_cell(cell_of(index));
  PlantedCell cell = drawn.planted;
  uint k = index - drawn.first_blade;
  WarpedRoot root = plant_root(cell, k);
  blades[index] = plant_blade(cell, load_species(cell.species), planting_features(cell, root_in_cell(cell, root)), root, k);
}
