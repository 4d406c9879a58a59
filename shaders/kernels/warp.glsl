// From uniform points to points of a given density: the exact inverse of the density inside a cell
// (docs/design.md, D2), which consists of m × m bilinear patches. First y by the marginal, then x by the
// conditional at that y; in both, a prefix sum finds the patch and one root the place in it. A patch without
// data has no mass and is never chosen.
//
// The cell's table of texels (generator/cell_table.h), m = patches:
//   rows:   m × ( mass below the row, sum along its lower edge, sum along its upper edge, mass of the cell )
//   nodes:  m × (m + 1) × ( sum along the row's lower edge west of the node, the same along its upper edge,
//                           density at the node on the lower edge, density on the upper edge; blades per m² )
// "Sum along an edge" is Σ of the mean of a patch's two end nodes over the patches with data, in units of
// patch sides.

// Where the integral of a linear density, a at 0 and b at 1, reaches the share u of its total. The textbook
// form (√(…) − a)/(b − a) cancels for a ≈ b.
float linear_density_root(float u, float a, float b) {
  precise float under_root = a * a * (1.0f - u) + b * b * u;
  precise float denominator = a + sqrt(under_root);
  precise float root = u * (a + b) / max(denominator, 1.0e-30f);
  return denominator > 0.0f ? min(root, 0.99999994f) : u;
}

// One step of a binary search: the place `step` further on, if there is one and the target lies beyond what
// it begins with. Written without branches and without a loop, so that compilers can plant several blades at
// once.
uint advance_row(uint table, uint patches, uint row, uint step, float target) {
  uint next = min(row + step, patches - 1u);
  return row + (next - row) * uint(target >= table_texel(table + next).x);
}

float mass_west_of(vec4 node, float ty) {
  return lerp(node.x, node.y, ty);
}

uint advance_column(uint nodes, uint patches, float ty, uint column, uint step, float target) {
  uint next = min(column + step, patches - 1u);
  return column + (next - column) * uint(target >= mass_west_of(table_texel(nodes + next), ty));
}

struct WarpedRoot {
  vec2 patch_xy;  // position in the cell, in patches: [0, m)²
  float density;  // of this species there, blades per m²
};

WarpedRoot warp_to_density(uint table, uint patches, vec2 point) {
  // A row or patch without mass begins where the next one does, so the search passes over it; those at the
  // end begin at the total, which no target reaches.
  precise float row_target = point.y * table_texel(table).w;
  uint row = advance_row(table, patches, 0u, 4u, row_target);
  row = advance_row(table, patches, row, 2u, row_target);
  row = advance_row(table, patches, row, 1u, row_target);
  vec4 row_texel = table_texel(table + row);
  float lower = row_texel.y;
  float upper = row_texel.z;
  precise float row_mass = 0.5f * (lower + upper);
  precise float v = saturate((row_target - row_texel.x) / max(row_mass, 1.0e-30f));
  float ty = linear_density_root(v, lower, upper);

  // The prefix sums of the columns are linear between the row's edges.
  uint nodes = table + patches + row * (patches + 1u);
  precise float target = point.x * lerp(lower, upper, ty);
  uint column = advance_column(nodes, patches, ty, 0u, 4u, target);
  column = advance_column(nodes, patches, ty, column, 2u, target);
  column = advance_column(nodes, patches, ty, column, 1u, target);
  vec4 west = table_texel(nodes + column);
  vec4 east = table_texel(nodes + column + 1u);
  float a = lerp(west.z, west.w, ty);
  float b = lerp(east.z, east.w, ty);
  precise float mass = 0.5f * (a + b);
  precise float u = saturate((target - mass_west_of(west, ty)) / max(mass, 1.0e-30f));
  float tx = linear_density_root(u, a, b);

  WarpedRoot root;
  root.patch_xy = vec2(float(int(column)) + tx, float(int(row)) + ty);
  root.density = lerp(a, b, tx);
  return root;
}
