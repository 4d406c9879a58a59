// Sky and haze (RG, "Fog"): what lies behind a distance takes the sky's colour, and the sun's where one looks
// towards it.

vec3 sky_radiance(vec3 direction) {
  float up = max(direction.z, 0.0f);
  float level = 1.0f - up, level2 = level * level;
  float low = level2 * level2 * level;
  vec3 sky = mix(light.zenith_radiance, light.horizon_radiance, low);
  float towards_sun = max(dot(direction, light.sun_direction), 0.0f);
  float halo = pow(towards_sun, light.sun_halo);
  return sky + light.sun_radiance * (0.10f * halo * (0.4f + 0.6f * low));
}

struct Haze {
  vec3 color;
  float share;
};

Haze haze_at(vec3 from_eye_m) {
  float distance_m = length(from_eye_m);
  vec3 direction = from_eye_m / max(distance_m, 1.0e-4f);
  Haze haze;
  haze.color = sky_radiance(vec3(direction.xy, max(direction.z, 0.0f) * 0.3f));
  haze.share = view.parallel > 0.5f ? 0.0f : 1.0f - exp(-light.haze_per_m * distance_m);
  return haze;
}

vec3 hazed(vec3 radiance, Haze haze) {
  return mix(radiance, haze.color, haze.share);
}
