// Light on blades (B11 §2.3): I = Ka Ia + Kd Id (max(N·L, 0) + C max(−N·L, 0)) + Is, with Ka = Kd = the
// albedo, Ia = Ia** + l (Ia* − Ia**), Id = Id* l⁶, Is = Ks l⁶ (1 − max(N_L·V, 0))¹⁰ and l = 0 at the root, 1
// at the tip. Deviations: Id falls to l⁶ only as far as the local density shades (`shade`); Is is largest at
// contours, as the text says, where the printed (N_L·V)¹⁰ is largest looking straight down, and is lit by the
// sky.

float power6(float l) {
  precise float l2 = l * l;
  return l2 * l2 * l2;
}

float power10(float x) {
  precise float x2 = x * x;
  precise float x4 = x2 * x2;
  return x4 * x4 * x2;
}

// Part of the sun that reaches height l of a blade, from l⁶.
float sun_share(float l6, float shade) {
  return lerp(1.0f, l6, shade);
}

// How strongly neighbours shade a blade: the probability that one stands in the way.
float shade_of(float density_per_m2, float shade_density_per_m2) {
  precise float x = density_per_m2 / shade_density_per_m2;
  // 1 − 1/(1 + x/2)² follows 1 − e^(−x) without an exponential.
  precise float y = 1.0f + 0.5f * x;
  return 1.0f - 1.0f / (y * y);
}

// `n_dot_l`: of the blade's normal on the viewer's side; `ground_n_dot_v`: N_L·V. `l6` is l⁶, or its mean
// around l.
vec3 blade_radiance_around(LightParams light, vec3 albedo, vec3 transmission, float specular, float l,
                           float l6, float shade, float n_dot_l, float ground_n_dot_v) {
  vec3 ambient = mixed(light.root_ambient, light.top_ambient, lerp(1.0f, l, shade));
  float sun = sun_share(l6, shade);
  float front = max(n_dot_l, 0.0f) * sun;
  float back = max(-n_dot_l, 0.0f) * sun;
  float contour = specular * l6 * power10(1.0f - saturate(ground_n_dot_v));
  return vec3(albedo.x * (ambient.x + light.sun_radiance.x * (front + transmission.x * back)) +
                  contour * light.horizon_radiance.x,
              albedo.y * (ambient.y + light.sun_radiance.y * (front + transmission.y * back)) +
                  contour * light.horizon_radiance.y,
              albedo.z * (ambient.z + light.sun_radiance.z * (front + transmission.z * back)) +
                  contour * light.horizon_radiance.z);
}

vec3 blade_radiance(LightParams light, vec3 albedo, vec3 transmission, float specular, float l, float shade,
                    float n_dot_l, float ground_n_dot_v) {
  return blade_radiance_around(light, albedo, transmission, specular, l, power6(l), shade, n_dot_l,
                               ground_n_dot_v);
}
