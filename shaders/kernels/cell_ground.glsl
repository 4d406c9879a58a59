// The ground inside a cell: the biquadratic surface through 3 × 3 heights (generator/cell_table.h; a texel a
// row, from south), relative to the tile's base. It meets its neighbours' without a step.

struct GroundPoint {
  float height_m;
  vec2 slope;  // ∂z/∂x, ∂z/∂y
};

GroundPoint ground_in_cell(uint table, float side_m, vec2 local_m) {
  precise float x = local_m.x / side_m;
  precise float y = local_m.y / side_m;
  // Lagrange basis on 0, ½, 1 and its derivative.
  precise vec3 bx = vec3(1.0f + x * (2.0f * x - 3.0f), 4.0f * x * (1.0f - x), x * (2.0f * x - 1.0f));
  precise vec3 by = vec3(1.0f + y * (2.0f * y - 3.0f), 4.0f * y * (1.0f - y), y * (2.0f * y - 1.0f));
  precise vec3 dx = vec3(4.0f * x - 3.0f, 4.0f - 8.0f * x, 4.0f * x - 1.0f);
  precise vec3 dy = vec3(4.0f * y - 3.0f, 4.0f - 8.0f * y, 4.0f * y - 1.0f);
  precise float height = 0.0f;
  precise float along_x = 0.0f;
  precise float along_y = 0.0f;
  for (uint row = 0u; row < 3u; ++row) {
    vec4 h = table_texel(table + row);
    float wy = row == 0u ? by.x : (row == 1u ? by.y : by.z);
    float vy = row == 0u ? dy.x : (row == 1u ? dy.y : dy.z);
    precise float value = bx.x * h.x + bx.y * h.y + bx.z * h.z;
    precise float slope = dx.x * h.x + dx.y * h.y + dx.z * h.z;
    height += wy * value;
    along_x += wy * slope;
    along_y += vy * value;
  }
  GroundPoint ground;
  ground.height_m = height;
  ground.slope = vec2(along_x / side_m, along_y / side_m);
  return ground;
}
