// Features that vary over the field (G03 §3.1): factors on the blades' length, bend and colour, bilinear on a
// lattice of the cell. Two texels a node: ( length, bend, –, – ), ( red, green, blue, – ).

struct Features {
  float blade_height;
  float bend;
  vec3 color;
};

Features no_features() {
  Features features;
  features.blade_height = 1.0f;
  features.bend = 1.0f;
  features.color = vec3(1.0f, 1.0f, 1.0f);
  return features;
}

float bilinear(float sw, float se, float nw, float ne, float tx, float ty) {
  return lerp(lerp(sw, se, tx), lerp(nw, ne, tx), ty);
}

Features features_in_cell(uint table, uint patches, float side_m, vec2 local_m) {
  precise float scale = float(patches) / side_m;
  precise float x = min(local_m.x * scale, float(patches) - 0.0001f);
  precise float y = min(local_m.y * scale, float(patches) - 0.0001f);
  uint column = uint(int(x));
  uint row = uint(int(y));
  precise float tx = x - float(int(column));
  precise float ty = y - float(int(row));
  uint south = table + 2u * (row * (patches + 1u) + column);
  uint north = south + 2u * (patches + 1u);
  vec4 sw = table_texel(south);
  vec4 se = table_texel(south + 2u);
  vec4 nw = table_texel(north);
  vec4 ne = table_texel(north + 2u);
  vec4 sw_color = table_texel(south + 1u);
  vec4 se_color = table_texel(south + 3u);
  vec4 nw_color = table_texel(north + 1u);
  vec4 ne_color = table_texel(north + 3u);
  Features features;
  features.blade_height = bilinear(sw.x, se.x, nw.x, ne.x, tx, ty);
  features.bend = bilinear(sw.y, se.y, nw.y, ne.y, tx, ty);
  features.color = vec3(bilinear(sw_color.x, se_color.x, nw_color.x, ne_color.x, tx, ty),
                        bilinear(sw_color.y, se_color.y, nw_color.y, ne_color.y, tx, ty),
                        bilinear(sw_color.z, se_color.z, nw_color.z, ne_color.z, tx, ty));
  return features;
}

// The features of a cell that may have none.
Features features_of(PlantedCell cell, vec2 local_m) {
  if (cell.feature_table == 0xffffffffu) return no_features();
  return features_in_cell(cell.feature_table, cell.feature_patches, cell.side_m, local_m);
}
