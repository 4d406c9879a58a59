// What is known of the eye that a pass draws for. A frame may have several. std140 and std430.

struct ViewParams {
  mat4 clip_from_eye;      // the eye's frame: origin at the eye, the scene's axes
  vec3 towards_eye;        // in a parallel projection
  float parallel;          // 1 in a parallel projection, else 0
  vec3 lod_eye_m;          // the eye for which tiers are chosen, as seen from this one
  float pixel_m;           // height of a pixel at 1 m (anywhere, in a parallel projection)
  vec3 ground_from_eye_m;  // the ground mesh's anchor as seen from the eye,
  float tint;              // 1: tiers are tinted
  vec2 anchor_m;           // and the anchor's place in the scene
  vec2 jitter;             // sub-pixel shift of clip space
  vec2 eye_in_tile_m;      // from the south-west corner of the tile that it is above
  vec2 window_from_eye_m;  // the middle of the moving fields' windows
  LodCoefficients lod;
};
