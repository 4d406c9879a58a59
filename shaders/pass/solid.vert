#version 450 core
// A vertex of something made of wood: of the mesh that all of its shape share, put where the thing is.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/solid_table.glsl"

layout(location = kFirstThing) uniform uint first_solid;

layout(location = 0) in vec3 place;  // shares of the half size, edges not yet rounded
layout(location = 1) in vec3 facing;

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out vec3 in_body_m;
layout(location = 2) out vec3 body_normal;
layout(location = 3) flat out uint solid_index;

void main() {
  solid_index = first_solid + uint(gl_InstanceID);
  SolidParams solid = solids[solid_index];
  in_body_m = place * (solid.half_size_m - solid.edge_m) + solid.edge_m * facing;
  body_normal = facing;
  from_eye_m = solid.centre_from_eye_m + scene_from_body(solid) * in_body_m;
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
