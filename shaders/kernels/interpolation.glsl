// Interpolation and short polynomials, written out: the built-in mix, smoothstep, sin and exp round
// differently on each side, + − × ÷ √ do not (docs/design.md, D1).

float lerp(float a, float b, float t) {
  return a + t * (b - a);
}

float saturate(float x) {
  return min(max(x, 0.0f), 1.0f);
}

float smooth_ramp(float x) {
  precise float t = saturate(x);
  precise float result = t * t * (3.0f - 2.0f * t);
  return result;
}

float square(float x) {
  return x * x;
}
