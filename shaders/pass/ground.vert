#version 450 core
// A vertex of the ground mesh. Positions are relative to an anchor, whole multiples of the finest quad in x and y, so that two
// patches compute the vertices of their common edge alike, bit for bit.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"

struct PatchParams {
  vec2 anchor_from_corner_m;
  float quad_m;
  float unused;
};
layout(std430, binding = 5) readonly buffer PatchTable { PatchParams patches[]; };
layout(location = 0) uniform uint vertices_per_side;

layout(location = 0) in float height_m;
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out vec3 ground_normal;

void main() {
  uint per_patch = vertices_per_side * vertices_per_side;
  uint slot = uint(gl_VertexID) / per_patch;
  uint vertex = uint(gl_VertexID) - slot * per_patch;
  PatchParams patch_params = patches[slot];
  vec2 node = vec2(float(vertex % vertices_per_side), float(vertex / vertices_per_side));
  vec3 anchored_m = vec3(patch_params.anchor_from_corner_m + node * patch_params.quad_m, height_m);
  from_eye_m = anchored_m + frame.ground_from_eye_m;
  ground_normal = normal;
  gl_Position = frame.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += frame.jitter * gl_Position.w;
}
