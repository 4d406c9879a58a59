#version 450 core
// The flat tier (G03 §3.5): ground in the mean colour of the blades that stand on it, and the soil between them. Where
// blades are drawn it is their shaded floor; where they have sunk with distance it stands for them.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"

vec4 table_texel(uint texel) { return vec4(0.0f); }
#include "shaders/pass/kernels.glsl"
#include "shaders/pass/haze.glsl"
#include "shaders/pass/value_noise.glsl"

layout(binding = 0) uniform sampler2D flat_map;  // rgb: mean albedo of the blades, a: the ground they cover

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 ground_normal;
layout(location = 0) out vec4 color;

// The flat map over a pixel's long, narrow footprint: four places along it, each with the footprint's width as its own.
// Done here rather than by anisotropic filters: they differ between devices, and Mesa's software renderer walks every
// texel of a footprint, which takes seconds where ground is seen edge-on.
vec4 flat_map_over_footprint(vec2 uv) {
  vec2 across = dFdx(uv);
  vec2 along = dFdy(uv);
  if (dot(across, across) > dot(along, along)) {
    vec2 other = across;
    across = along;
    along = other;
  }
  vec4 sum = vec4(0.0);
  for (int n = 0; n < 4; ++n) {
    sum += textureGrad(flat_map, uv + along * ((float(n) + 0.5) / 4.0 - 0.5), across, along * 0.25);
  }
  return 0.25 * sum;
}

void main() {
  vec2 place_m = frame.anchor_m + (from_eye_m.xy - frame.ground_from_eye_m.xy);
  vec2 period_m = vec2(frame.flat_period_x_m, frame.flat_period_y_m);
  vec4 grass = flat_map_over_footprint(place_m / period_m + 0.5 / vec2(textureSize(flat_map, 0)));

  float distance_m = length(from_eye_m);
  float detail = frame.parallel > 0.5 ? 1.0 : saturate(1.5 - distance_m / 60.0);
  float grain = mix(0.5, 0.65 * value_noise(place_m * 9.0) + 0.35 * value_noise(place_m * 37.0), detail);
  float patchy = value_noise(place_m * 0.9);
  grass.a = saturate(grass.a + 0.5 * (grain - 0.5) * grass.a * (1.0 - grass.a) * 4.0);

  vec3 normal = normalize(ground_normal);
  vec3 to_eye = frame.parallel > 0.5 ? frame.towards_eye : -from_eye_m / max(distance_m, 1e-4);
  float n_dot_v = saturate(dot(normal, to_eye));
  // What covers a share of the ground from above covers more of it the flatter one looks: leaf area along the ray.
  float slant = sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)) / max(n_dot_v, 0.02);
  float cover = 1.0 - pow(1.0 - min(grass.a, 0.999), 1.0 + 1.6 * slant);

  float n_dot_l = dot(normal, frame.sun_direction);
  vec3 soil_albedo = frame.soil_color * (0.6 + 0.8 * grain);
  vec3 soil = soil_albedo * (frame.top_ambient + frame.sun_radiance * max(n_dot_l, 0.0));

  // Blades turn every way, so a slope changes what the sun gives them by less than it changes flat ground's.
  float tilt = mix(1.0, clamp(n_dot_l / max(frame.sun_direction.z, 0.05), 0.0, 2.0), 0.5);
  float contour = 0.05 * power10(1.0 - n_dot_v);
  vec3 sward = grass.rgb * frame.flat_response * tilt * (0.86 + 0.28 * patchy) + contour * frame.horizon_radiance * cover;

  // Between standing blades: dead leaves in the sward's shade.
  vec3 litter = mix(grass.rgb, vec3(0.10, 0.085, 0.04), 0.3) * (0.55 + 0.9 * grain);
  vec3 floor_of_sward = mix(soil, litter * (frame.root_ambient * 1.3 + 0.035 * frame.sun_radiance), smooth_ramp(1.6 * grass.a));

  vec3 distant = mix(floor_of_sward, sward, cover);

  // Where blades are thinned, gaps between them stand for blades; where they have sunk, the ground does.
  float pixel_m = frame.parallel > 0.5 ? frame.pixel_m : frame.pixel_m * distance_m;
  float standing = smooth_ramp(2.5 * keep_share(frame.lod, n_dot_v, pixel_m, distance_m));
  color = vec4(hazed(mix(distant, floor_of_sward, standing), from_eye_m), 1.0);
}
