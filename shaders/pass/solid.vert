#version 450 core
// A vertex of something solid: of the mesh that all of its shape share, put where the thing is. A rough sphere is dented
// here, inwards only, so that what treads the grass as a sphere is nowhere drawn outside it.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"
#include "shaders/shared/solid.glsl"
#include "shaders/pass/stone.glsl"

layout(std430, binding = 5) readonly buffer SolidTable { SolidParams solids[]; };
layout(location = 0) uniform uint first_solid;

layout(location = 0) in vec3 place;   // shares of the half size, edges not yet rounded
layout(location = 1) in vec3 facing;

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out vec3 in_body_m;
layout(location = 2) out vec3 body_normal;
layout(location = 3) flat out SolidParams solid;

void main() {
  solid = solids[first_solid + uint(gl_InstanceID)];
  in_body_m = place * (solid.half_size_m - solid.edge_m) + solid.edge_m * facing;
  if (solid.outline_roughness > 0.0)
    in_body_m *= 1.0 - solid.outline_roughness * stone_shape(place, solid, kDentLayers, 0.0).dent.w;
  body_normal = facing;
  from_eye_m = solid.centre_from_eye_m + mat3(solid.forward, solid.left, solid.up) * in_body_m;
  gl_Position = frame.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += frame.jitter * gl_Position.w;
}
