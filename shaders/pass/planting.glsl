// Bindings and work distribution that the planting shaders share: one invocation per blade, workgroups span cells.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Cells { DrawnCell cells[]; };
layout(std430, binding = 1) readonly buffer Tables { float tables[]; };
layout(std430, binding = 2) readonly buffer SpeciesTable { SpeciesParams species_table[]; };
layout(std430, binding = 3) readonly buffer GroupCells { uint first_cell_of_group[]; };

layout(location = 0) uniform uint blade_count;

float table_value(uint word) { return tables[word]; }

// The cell that blade `index` of the batch belongs to, from its workgroup's first one on.
uint cell_of(uint index) {
  uint cell = first_cell_of_group[index / 64u];
  while (index >= cells[cell].first_blade + cells[cell].drawn) ++cell;
  return cell;
}
