// A planted cell as a frame draws it in 3D blades. std430.

struct DrawnCell {
  PlantedCell planted;
  vec3 eye_from_tile_m;  // the tile's origin as seen from the eye, along the scene's axes
  uint first_blade;      // where its blades begin in the batch's output
  uint drawn;            // how many of its (quarter's) blades are drawn at most: those from first_index on
  uint quarter;          // 0: the whole cell; else which of its quarters (shaders/kernels/quarter.glsl)
  uint first_index;      // 0, but in the later pieces of a cell too large for one buffer
  float morph;           // how far its tile has morphed from 3D blades (0) to strips (1)
};
