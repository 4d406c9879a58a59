#version 450 core
// The sky's upper half as a map in which a direction lies at direction.xy / (1 + direction.z): made once per
// light, read by shaders/pass/sky.frag for every pixel of every frame.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
vec4 table_texel(uint texel) {
  return vec4(0.0f);
}
#include "shaders/lib/kernels.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/value_noise.glsl"

layout(location = 0) in vec2 clip_xy;
layout(location = 0) out vec4 color;

// Fair-weather clouds on a plane high above, from five octaves of noise; thin ones let the sky through.
float cloud_cover(vec2 place) {
  float sum = 0.0;
  float weight = 0.5;
  for (int octave = 0; octave < 5; ++octave) {
    sum += weight * value_noise(place);
    place = mat2(1.6, 1.2, -1.2, 1.6) * place + 7.3;
    weight *= 0.5;
  }
  return smooth_ramp((sum - 0.50) * 3.2);
}

void main() {
  float radius2 = dot(clip_xy, clip_xy);
  vec3 direction = vec3(2.0 * clip_xy, 1.0 - radius2) / (1.0 + radius2);
  direction = normalize(vec3(direction.xy, max(direction.z, 0.0)));
  vec3 sky = sky_radiance(direction);
  float clouds = cloud_cover(direction.xy / (direction.z + 0.12) * vec2(1.1, 1.7) + 3.0) *
                 smooth_ramp(direction.z * 5.0 - 0.15);
  float towards_sun = max(dot(direction, light.sun_direction), 0.0);
  vec3 lit = 1.15 * light.horizon_radiance + light.sun_radiance * (0.05 + 0.25 * pow(towards_sun, 6.0));
  color = vec4(mix(sky, lit, 0.75 * clouds), 0.0);
}
