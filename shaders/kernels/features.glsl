// Features that vary over the field (G03 §3.1): factors on the blades' length, bend and colour, bilinear on a lattice of
// the cell. Five words a node: length, bend, red, green, blue.

struct Features {
  float blade_height;
  float bend;
  vec3 color;
};

float feature_between(uint corner, uint row_stride, float tx, float ty) {
  precise float south = lerp(table_value(corner), table_value(corner + 5u), tx);
  precise float north = lerp(table_value(corner + row_stride), table_value(corner + row_stride + 5u), tx);
  return lerp(south, north, ty);
}

Features features_in_cell(uint table, uint patches, float side_m, vec2 local_m) {
  Features features;
  features.blade_height = 1.0f;
  features.bend = 1.0f;
  features.color = vec3(1.0f, 1.0f, 1.0f);
  if (table == 0xffffffffu) return features;
  precise float scale = float(patches) / side_m;
  precise float x = min(local_m.x * scale, float(patches) - 0.0001f);
  precise float y = min(local_m.y * scale, float(patches) - 0.0001f);
  uint column = uint(x);
  uint row = uint(y);
  precise float tx = x - float(column);
  precise float ty = y - float(row);
  uint row_stride = 5u * (patches + 1u);
  uint corner = table + row * row_stride + 5u * column;
  features.blade_height = feature_between(corner, row_stride, tx, ty);
  features.bend = feature_between(corner + 1u, row_stride, tx, ty);
  features.color = vec3(feature_between(corner + 2u, row_stride, tx, ty), feature_between(corner + 3u, row_stride, tx, ty),
                        feature_between(corner + 4u, row_stride, tx, ty));
  return features;
}
