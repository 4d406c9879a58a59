#version 450 core
// A vertex of a posed blade: a point of its Hermite curve, half a width to one side; lit here (B11 §2.3), since blades are a
// pixel or two wide. Vertices come in pairs from the foot up, the last one is the tip.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"

vec4 table_texel(uint texel) { return vec4(0.0f); }
#include "shaders/pass/kernels.glsl"
#include "shaders/pass/haze.glsl"

layout(binding = 2) uniform samplerBuffer species_texels;  // SpeciesParams
layout(binding = 4) uniform usamplerBuffer posed_texels;   // PosedBlade
layout(location = 0) uniform uint segments;

layout(location = 0) out vec3 radiance;

PosedBlade load_blade(uint index) {
  int first = int(index) * kPosedTexels;
  uvec4 a = texelFetch(posed_texels, first);
  uvec4 b = texelFetch(posed_texels, first + 1);
  uvec4 c = texelFetch(posed_texels, first + 2);
  uvec4 d = texelFetch(posed_texels, first + 3);
  uvec4 e = texelFetch(posed_texels, first + 4);
  PosedBlade blade;
  blade.base_m = uintBitsToFloat(a.xyz);
  blade.width_m = uintBitsToFloat(a.w);
  blade.tip_m = uintBitsToFloat(b.xyz);
  blade.shade = uintBitsToFloat(b.w);
  blade.base_tangent_m = uintBitsToFloat(c.xyz);
  blade.root_color = c.w;
  blade.tip_tangent_m = uintBitsToFloat(d.xyz);
  blade.tip_color = d.w;
  blade.side = uintBitsToFloat(e.xyz);
  blade.species_and_normal = e.w;
  return blade;
}

void main() {
  uint vertices = 2u * segments + 1u;
  uint index = uint(gl_VertexID) / vertices;
  uint vertex = uint(gl_VertexID) - index * vertices;
  PosedBlade blade = load_blade(index);
  float t = float(vertex / 2u) / float(segments);
  float sign = vertex == 2u * segments ? 0.0f : ((vertex & 1u) == 0u ? -1.0f : 1.0f);

  vec3 centre_m = hermite_point(blade.base_m, blade.tip_m, blade.base_tangent_m, blade.tip_tangent_m, t);
  vec3 along = hermite_derivative(blade.base_m, blade.tip_m, blade.base_tangent_m, blade.tip_tangent_m, t);
  vec3 to_eye = frame.parallel > 0.5f ? frame.towards_eye : normalized(-centre_m);

  BladeSurface surface = blade_surface(along, blade.side, to_eye);
  vec3 position_m = centre_m + surface.side * (0.5f * sign * blade.width_m * blade_profile(t));
  vec3 normal = sign < 0.0f ? surface.left : (sign > 0.0f ? surface.right : normalized(surface.left + surface.right));
  vec2 ground_xy = vec2(float((blade.species_and_normal >> 12u) & 4095u), float(blade.species_and_normal & 4095u)) / 4095.0f * 2.0f - 1.0f;
  vec3 ground_normal = vec3(ground_xy, sqrt(max(1.0f - dot(ground_xy, ground_xy), 0.0f)));

  vec4 transmission = texelFetch(species_texels, int(blade.species_and_normal >> 24u) * kSpeciesTexels + 3);  // and specular
  vec3 albedo = mix(unpack_color(blade.root_color), unpack_color(blade.tip_color), t);
  vec3 lit = blade_radiance(frame, albedo, transmission.rgb, transmission.a, t, blade.shade,
                            dot(normal, frame.sun_direction), dot(ground_normal, to_eye));
  radiance = hazed(lit, position_m);
  gl_Position = frame.clip_from_eye * vec4(position_m, 1.0f);
  gl_Position.xy += frame.jitter * gl_Position.w;
}
