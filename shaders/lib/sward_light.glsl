// The light on what stands in a sward.

// What of the sky and of the sun a place sees this far above the ground: blades around take most of it next
// to their feet.
const float kLeastSky = 0.22;
const float kLeastSun = 0.10;
// Light that sunlit grass throws up at a face that looks straight down.
const float kBounce = 0.45;

// So far above the ground, in a sward that darkens what is below `in_sward_m`.
vec2 open_above(float above_m, float in_sward_m) {
  float in_sward = 1.0 - smoothstep(0.0, in_sward_m, max(above_m, 0.0));
  return mix(vec2(1.0), vec2(kLeastSky, kLeastSun), in_sward);
}

// `rise`, `sunward`: cosines of the surface's normal to straight up and to the sun.
vec3 solid_light(float rise, float sunward, vec2 sky_and_sun) {
  vec3 ambient = mix(light.root_ambient, light.top_ambient, 0.5 + 0.5 * rise);
  ambient +=
      kBounce * (0.5 - 0.5 * rise) * field.mean_albedo * light.sun_radiance * max(light.sun_direction.z, 0.0);
  return sky_and_sun.x * ambient + sky_and_sun.y * max(sunward, 0.0) * light.sun_radiance;
}
