// A planted blade: what the seed, the maps and its tuft make of it, before wind and light. std430.

struct Blade {
  vec2 root_m;          // relative to the tile's south-west corner
  float ground_m;       // height of the ground at the root, above the tile's base
  float height_m;       // length along the midrib
  float width_m;        // at the widest place
  float azimuth_rad;    // direction in which it bends, counter-clockwise from east
  float tilt_rad;       // angle of its foot to the ground's normal
  float curvature_rad;  // turning from foot to tip
  vec2 lean;            // displacement of the tip by its tuft, as a share of its length (east, north)
  float hue;            // −1 bluish … +1 yellowish
  float dryness;        // 0 green … 1 straw
  float stiffness;      // spring constant over m g l (B11 §3.1)
  float mass_g;
  float phase_rad;  // of its own sway
  uint identity;    // species (6 bits), cell of the tile (2), index in the cell (24)
};
