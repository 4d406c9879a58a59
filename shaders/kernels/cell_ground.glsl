// The ground inside a cell: the biquadratic surface through 3 × 3 heights (generator/cell_table.h), relative to the
// tile's base. It meets its neighbours' without a step.

struct GroundPoint {
  float height_m;
  vec2 slope;       // ∂z/∂x, ∂z/∂y
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
  for (int row = 0; row < 3; ++row) {
    uint first = table + 3u * uint(row);
    float h0 = table_value(first);
    float h1 = table_value(first + 1u);
    float h2 = table_value(first + 2u);
    float wy = row == 0 ? by.x : (row == 1 ? by.y : by.z);
    float vy = row == 0 ? dy.x : (row == 1 ? dy.y : dy.z);
    precise float value = bx.x * h0 + bx.y * h1 + bx.z * h2;
    precise float slope = dx.x * h0 + dx.y * h1 + dx.z * h2;
    height += wy * value;
    along_x += wy * slope;
    along_y += vy * value;
  }
  GroundPoint ground;
  ground.height_m = height;
  ground.slope = vec2(along_x / side_m, along_y / side_m);
  return ground;
}
