#version 450 core
// A vertex of an arrow of the wind, or of a square of heat on the ground (render/overlays/field_overlay.h).
#include "shaders/lib/layouts.glsl"
#include "shaders/shared/field_overlay.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out float heat;
layout(location = 2) out float wear;
layout(location = 3) out float outline;  // 1: the dark edge of an arrow

#ifdef WIND_ARROWS
layout(std430, binding = kThingBuffer) readonly buffer Arrows {
  WindArrow arrows[];
};

const float kShaftHalfM = 0.055;
const float kHeadHalfM = 0.17;
const float kHeadM = 0.38;
const float kOutlineM = 0.03;
const float kHottestMPerS = 16.0;

const float kWidenedFromM = 8.0;  // farther arrows are wider, since one sees them ever more from the side

// Ahead and to the left of the arrow's middle: a shaft of two triangles, then the head. `grown_m`: outwards.
vec2 arrow_corner(int corner, float length_m, float widened, float grown_m) {
  float head_m = min(kHeadM * (0.7 + 0.3 * widened), 0.6 * length_m);
  float slim = min(length_m / 0.9, 1.0) * widened;
  float tip = 0.5 * length_m, foot = -tip - grown_m, neck = tip - head_m;
  float half_m = slim * kShaftHalfM + grown_m, wing_m = slim * kHeadHalfM + 1.7 * grown_m;
  vec2 corners[9] = vec2[9](vec2(foot, -half_m), vec2(neck, -half_m), vec2(neck, half_m), vec2(foot, -half_m),
                            vec2(neck, half_m), vec2(foot, half_m), vec2(neck - grown_m, -wing_m),
                            vec2(tip + 2.2 * grown_m, 0.0), vec2(neck - grown_m, wing_m));
  return corners[corner];
}

void main() {
  WindArrow arrow = arrows[gl_InstanceID];
  outline = gl_VertexID < 9 ? 1.0 : 0.0;
  float length_m = length(arrow.along_m);
  vec2 ahead = arrow.along_m / length_m;
  float widened = max(length(arrow.middle_from_eye_m.xy) / kWidenedFromM, 1.0);
  vec2 corner = arrow_corner(gl_VertexID % 9, length_m, widened, kOutlineM * widened * outline);
  vec2 over_ground_m = corner.x * ahead + corner.y * vec2(-ahead.y, ahead.x);
  from_eye_m = arrow.middle_from_eye_m + vec3(over_ground_m, dot(arrow.slope, over_ground_m));
  heat = clamp(arrow.speed_m_per_s / kHottestMPerS, 0.0, 1.0);
  wear = 0.0;
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
#else
layout(std430, binding = kThingBuffer) readonly buffer Squares {
  HeatSquare squares[];
};

void main() {
  HeatSquare square = squares[gl_InstanceID];
  int corners[6] = int[6](0, 1, 3, 0, 3, 2);
  int corner = corners[gl_VertexID];
  vec2 share = vec2(float(corner % 2), float(corner / 2));
  from_eye_m = vec3(square.corner_from_eye_m + square.side_m * share, square.heights_from_eye_m[corner]);
  heat = square.heat[corner];
  wear = square.wear;
  outline = 0.0;
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
#endif
