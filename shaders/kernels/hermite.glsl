// Points and derivatives of a cubic Hermite curve (G03 §3.3).

vec3 hermite_point(vec3 p0, vec3 p1, vec3 m0, vec3 m1, float t) {
  precise float s = 1.0f - t;
  precise float h00 = (1.0f + 2.0f * t) * s * s;
  precise float h10 = t * s * s;
  precise float h01 = t * t * (3.0f - 2.0f * t);
  precise float h11 = -(t * t * s);
  precise vec3 result = p0 * h00 + m0 * h10 + p1 * h01 + m1 * h11;
  return result;
}

vec3 hermite_derivative(vec3 p0, vec3 p1, vec3 m0, vec3 m1, float t) {
  precise float s = 1.0f - t;
  precise float d01 = 6.0f * t * s;
  precise float d10 = s * (1.0f - 3.0f * t);
  precise float d11 = t * (3.0f * t - 2.0f);
  precise vec3 result = (p1 - p0) * d01 + m0 * d10 + m1 * d11;
  return result;
}

// Width along a blade, as a share of its widest place: a broad foot, a long taper, a pointed tip.
float blade_profile(float t) {
  precise float narrow = t * t;
  precise float result =
      (1.0f - narrow * narrow * 0.35f - 0.65f * narrow * t) * (0.8f + 0.2f * min(4.0f * t, 1.0f));
  return max(result, 0.0f);
}
