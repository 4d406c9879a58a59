#version 450 core
// A strip (G03 §3.4): the alpha test shows as many of its texture's blades as the density asks for.
#include "shaders/shared/strip_scale.glsl"

layout(binding = 0) uniform sampler2DArray strip_texture;  // rgb: radiance over its mean / kBrightest, a: rank of the blade

layout(location = 0) in vec3 radiance;
layout(location = 1) in vec3 place;
layout(location = 2) in vec2 shown_and_contrast;
layout(location = 0) out vec4 color;

void main() {
  vec4 blade = texture(strip_texture, place);
  if (blade.a >= shown_and_contrast.x) discard;
  color = vec4(radiance * mix(vec3(1.0), kBrightest * blade.rgb, shown_and_contrast.y), 1.0);
}
