// From linear light to what an 8-bit picture holds: a filmic curve per channel (a rational fit of a camera's
// response, in the form of Hable 2010 and Narkowicz 2015), then the sRGB transfer function.

float tone_curve(float x) {
  precise float result = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
  return saturate(result);
}

// The sRGB transfer function. It ends in 8 bits, so the built-in pow serves.
float srgb_from_linear(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 0.41666667f) - 0.055f;
}
