// Colours that tell tiers apart, laid over radiance where a person asks for them.
const vec3 kSplineTint = vec3(1.0, 0.25, 0.2);
const vec3 kHermiteTint = vec3(1.0, 0.85, 0.2);
const vec3 kStripTint = vec3(0.25, 1.0, 0.3);
const vec3 kFlatTint = vec3(0.3, 0.5, 1.0);

vec3 tinted_tier(vec3 radiance, vec3 tint) {
  float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  return mix(radiance, 1.4 * luminance * tint, 0.75 * view.tint);
}
