#version 450 core
// A strip (G03 §3.4): the alpha test shows as many of its texture's blades as the density asks for.
#include "shaders/shared/bindings.glsl"
#include "shaders/shared/strip_scale.glsl"

layout(binding = kStripUnit) uniform sampler2DArray
    strip_texture;  // rgb: radiance over its mean / kBrightest, a: rank of the blade

layout(location = 0) in vec3 radiance;
layout(location = 1) in vec3 place;
layout(location = 2) in float shown;
layout(location = 0) out vec4 color;

// A blade that is about to go has the mean colour, which is what the ground behind it has, so that it goes
// unseen.
const float kFadingRanks = 0.16;

void main() {
  vec4 blade = texture(strip_texture, place);
  float before_going = shown - blade.a;
  if (before_going <= 0.0) discard;
  vec3 own = kBrightest * blade.rgb;
  color = vec4(radiance * mix(vec3(1.0), own, min(before_going / kFadingRanks, 1.0)), 1.0);
}
