// What is drawn over the picture to show fields, as seen from the eye along the scene's axes. std430.

struct WindArrow {
  vec3 middle_from_eye_m;
  float speed_m_per_s;
  vec2 along_m;  // from its foot to its tip, over the ground
  vec2 slope;    // of the ground below
};

// A square of four nodes: south-west, south-east, north-west, north-east.
struct HeatSquare {
  vec2 corner_from_eye_m;  // south-west
  float side_m;
  float wear;  // mean of the four, 0…1
  vec4 heights_from_eye_m;
  vec4 heat;  // 0…1
};
