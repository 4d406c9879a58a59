// A vertex of a strip as a frame draws it, as seen from the eye along the scene's axes. std430.

struct StripVertex {
  vec3 position_m;
  uint radiance;  // packed (shaders/kernels/radiance.glsl): the mean of what the blades show
  vec2 place;     // in the strips' texture
  float layer;
  float shown;  // share of the texture's blades
};
