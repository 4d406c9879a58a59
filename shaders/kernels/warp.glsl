// From uniform points to points of a given density: the exact inverse of the density inside a cell (docs/design.md, D2),
// which consists of m × m bilinear patches. First y by the marginal, then x by the conditional at that y; in both, a
// prefix sum finds the patch and one root the place in it. A patch without data has no mass and is never chosen.
//
// The cell's table of floats (generator/cell_table.h), m = patches:
//   rows:   m × { mass below the row, sum along its lower edge, sum along its upper edge }
//   sums:   m × m × { sum along the lower edge west of the patch, the same along the upper edge }
//   nodes:  (m + 1) × (m + 1) densities, blades per m²
// "Sum along an edge" is Σ of the mean of a patch's two end nodes over the patches with data, in units of patch sides.

// Where the integral of a linear density, a at 0 and b at 1, reaches the share u of its total. The textbook form
// (√(…) − a)/(b − a) cancels for a ≈ b.
float linear_density_root(float u, float a, float b) {
  precise float under_root = a * a * (1.0f - u) + b * b * u;
  precise float denominator = a + sqrt(under_root);
  if (denominator <= 0.0f) return u;
  precise float root = u * (a + b) / denominator;
  return min(root, 0.99999994f);
}

struct WarpedRoot {
  vec2 patch_xy;   // position in the cell, in patches: [0, m)²
  float density;   // of this species there, blades per m²
};

WarpedRoot warp_to_density(uint table, uint patches, vec2 point) {
  uint sums = table + 3u * patches;
  uint nodes = sums + 2u * patches * patches;

  // Row: the last one with mass whose mass below does not exceed the target.
  uint last = patches - 1u;
  precise float total = table_value(table + 3u * last) +
                        0.5f * (table_value(table + 3u * last + 1u) + table_value(table + 3u * last + 2u));
  precise float target = point.y * total;
  uint row = 0u;
  float row_below = 0.0f;
  float lower = 0.0f;
  float upper = 0.0f;
  for (uint r = 0u; r < patches; ++r) {
    float below = table_value(table + 3u * r);
    float low = table_value(table + 3u * r + 1u);
    float high = table_value(table + 3u * r + 2u);
    if (low + high > 0.0f && (target >= below || lower + upper <= 0.0f)) {
      row = r;
      row_below = below;
      lower = low;
      upper = high;
    }
  }
  precise float row_mass = 0.5f * (lower + upper);
  precise float v = row_mass > 0.0f ? saturate((target - row_below) / row_mass) : point.y;
  float ty = linear_density_root(v, lower, upper);

  // Column, at that height: the prefix sums are linear between the row's edges.
  precise float across = lerp(lower, upper, ty);
  target = point.x * across;
  uint column = 0u;
  float column_below = 0.0f;
  float column_mass = 0.0f;
  float west = lerp(table_value(sums + 2u * patches * row), table_value(sums + 2u * patches * row + 1u), ty);
  for (uint c = 0u; c < patches; ++c) {
    precise float east = across;
    if (c < last) {
      uint next = sums + 2u * (patches * row + c + 1u);
      east = lerp(table_value(next), table_value(next + 1u), ty);
    }
    precise float mass = east - west;
    if (mass > 0.0f && (target >= west || column_mass <= 0.0f)) {
      column = c;
      column_below = west;
      column_mass = mass;
    }
    west = east;
  }
  precise float u = column_mass > 0.0f ? saturate((target - column_below) / column_mass) : point.x;

  uint corner = nodes + row * (patches + 1u) + column;
  float a = lerp(table_value(corner), table_value(corner + patches + 1u), ty);
  float b = lerp(table_value(corner + 1u), table_value(corner + patches + 2u), ty);
  float tx = linear_density_root(u, a, b);

  WarpedRoot root;
  root.patch_xy = vec2(float(column) + tx, float(row) + ty);
  root.density = lerp(a, b, tx);
  return root;
}
