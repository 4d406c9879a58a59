// The strips of one species around one tile (G03 §3.4). std430.

struct StripTile {
  vec3 eye_from_tile_m;  // the tile's origin as seen from the eye, along the scene's axes
  float side_m;
  float grown;         // how much of their height stands out of the ground
  float blade_height;  // factor on the blades' length
  uint species;
  uint seed;                   // shifts the texture along each side
  vec3 color;                  // factor on the blades' colour
  float other_density_per_m2;  // mean density of the other species, per tile
  vec4 density_per_m2;         // means over the cells south-west, south-east, north-west, north-east
  vec4 south_m;  // heights of the ground above the tile's origin, at every quarter of each side but its end,
  vec4 east_m;   // counter-clockwise from the south-west corner
  vec4 north_m;
  vec4 west_m;
};
