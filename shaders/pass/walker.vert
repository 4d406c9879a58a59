#version 450 core
// A vertex of a walker: of the figure that all share, carried by two bones at most (linear blending).
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/walker_table.glsl"

layout(location = kFirstThing) uniform uint first_walker;

layout(location = 0) in vec3 place_m;  // of the resting figure
layout(location = 1) in vec3 facing;
layout(location = 2) in uvec4 skinning;  // two joints, 255ths of the second's weight, material
layout(location = 3) in float openness;  // to the sky, next to the figure's other parts

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 rest_place_m;
layout(location = 3) out float open_share;
layout(location = 4) flat out uint walker_index;
layout(location = 5) flat out uint material;

void main() {
  walker_index = first_walker + uint(gl_InstanceID);
  uint a = 3u * skinning.x, b = 3u * skinning.y;
  float weight = float(skinning.z) / 255.0;
  vec4 row[3];
  for (uint n = 0u; n < 3u; ++n)
    row[n] = mix(walkers[walker_index].bones[a + n], walkers[walker_index].bones[b + n], weight);
  vec4 at = vec4(place_m, 1.0);
  from_eye_m = vec3(dot(row[0], at), dot(row[1], at), dot(row[2], at));
  normal = vec3(dot(row[0].xyz, facing), dot(row[1].xyz, facing), dot(row[2].xyz, facing));
  rest_place_m = place_m;
  open_share = openness;
  material = skinning.w;
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
