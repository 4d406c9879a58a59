// The painted look of stones (shaders/pass/stone_map.frag), turned about by their seed so that no two lie
// alike.
#include "shaders/lib/octahedral.glsl"
layout(binding = kStoneAlbedoUnit) uniform sampler2D stone_albedo_map;
layout(binding = kStoneSurfaceUnit) uniform sampler2D stone_surface_map;

vec3 turned_by_seed(vec3 v, uint seed) {
  uint turn = seed % 12u;
  vec3 signs = vec3((turn & 1u) == 0u ? 1.0 : -1.0, (turn & 2u) == 0u ? 1.0 : -1.0, 1.0);
  signs.z = signs.x * signs.y;
  v *= signs;
  uint cycle = turn / 4u;
  return cycle == 0u ? v : (cycle == 1u ? v.yzx : v.zxy);
}

// How deep the surface lies under the sphere, 0 to 1.
float stone_dent_at(vec3 on_map) {
  return textureLod(stone_surface_map, octahedral_place(on_map), 0.0).w;
}
