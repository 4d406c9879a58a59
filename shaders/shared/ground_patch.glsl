// A patch of the ground's mesh. std430.

struct GroundPatchParams {
  vec2 corner_from_anchor_m;  // of its south-west corner
  float quad_m;
  float reserved;  // fills the struct up to its vec2
};
