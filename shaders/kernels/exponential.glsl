// The falling exponential by a polynomial (relative error below 3e-7).

// e^(−x) for x ≥ 0; 0 from 87 on, where floats lose their precision.
float falling_exponential(float x) {
  float within = min(max(x, 0.0f), 87.0f);
  precise float halvings = floor(within * 1.4426950408889634f + 0.5f);
  precise float y =
      (within - halvings * 0.693359375f) + halvings * 2.12194440e-4f;  // ln 2 in two parts (Cody & Waite)
  // Taylor's series on |y| ≤ ln(2)/2.
  precise float p = 1.3888889e-3f;
  p = p * y - 8.3333333e-3f;
  p = p * y + 4.1666667e-2f;
  p = p * y - 1.6666667e-1f;
  p = p * y + 0.5f;
  p = p * y - 1.0f;
  p = p * y + 1.0f;
  precise float result = p * uintBitsToFloat(uint(127 - int(halvings)) << 23u);
  return x < 87.0f ? result : 0.0f;
}
