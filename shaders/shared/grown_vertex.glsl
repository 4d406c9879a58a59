// A vertex of a 3D blade as a frame draws it, as seen from the eye along the scene's axes. std430.

struct GrownVertex {
  vec3 position_m;
  uint radiance;  // packed (shaders/kernels/radiance.glsl)
};
