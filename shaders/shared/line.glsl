// A line drawn over the picture, as seen from the eye along the scene's axes. std430.

struct LineParams {
  vec3 start_from_eye_m;
  float reserved_of_start;  // these fill the rows
  vec3 end_from_eye_m;
  float reserved_of_end;
  vec4 color;  // linear; its cover
};
