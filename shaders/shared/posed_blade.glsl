// A blade as a frame draws it: a Hermite curve (G03 §3.3) with width, side and colours. Positions as seen from the eye,
// along the scene's axes. std430.

struct PosedBlade {
  vec3 base_m;
  float width_m;
  vec3 tip_m;
  float shade;             // self-shading by neighbours, 0 free … 1 in dense grass
  vec3 base_tangent_m;     // derivative of the curve by its parameter t ∈ [0, 1]
  uint root_color;         // packed linear RGB albedo (shaders/kernels/color.glsl)
  vec3 tip_tangent_m;
  uint tip_color;
  vec3 side;               // unit vector across the blade
  uint species_and_normal;  // species in the upper 8 bits, ground normal's x and y in 12 bits each
};
