// Dead leaves between blades, in the sward's shade. `albedo`: of the blades.
vec3 litter_radiance(vec3 albedo) {
  return mix(albedo, vec3(0.10, 0.085, 0.04), 0.3) * (light.root_ambient * 1.3 + 0.035 * light.sun_radiance);
}
