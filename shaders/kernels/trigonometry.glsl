// Sine and cosine by polynomials (odd minimax fit on a quarter turn; absolute error below 4e-7 for |x| ≤ 2π,
// all of it from rounding).

// Quarter-wave kernel: sin of x in [−π/2, π/2].
float sine_of_quarter(float x) {
  precise float z = x * x;
  precise float p = 2.6000547678828055e-6f;
  p = p * z - 1.9806615201347234e-4f;
  p = p * z + 8.333017291562118e-3f;
  p = p * z - 1.6666657096504692e-1f;
  precise float result = x + x * z * p;
  return result;
}

float sine(float x) {
  precise float turns = floor(x * 0.15915494309189535f + 0.5f);
  precise float y =
      (x - turns * 6.28125f) - turns * 1.9353071795864769e-3f;  // 2π in two parts (Cody & Waite)
  float folded = y;
  if (y > 1.5707963267948966f) folded = 3.1415926535897931f - y;
  if (y < -1.5707963267948966f) folded = -3.1415926535897931f - y;
  return sine_of_quarter(folded);
}

float cosine(float x) {
  return sine(x + 1.5707963267948966f);
}
