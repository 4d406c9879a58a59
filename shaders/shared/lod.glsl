// Coefficients of the weight function (shaders/kernels/weight.glsl). std430 and std140.

struct LodCoefficients {
  float a1;          // F's trinomial a1 + a2 d + a3 d² (B11 §2.2); d in metres at the reference pixel
  float a2;
  float a3;
  float fade;        // share of the drawn blades that are still growing in
  float reference_pixel;  // height of a pixel at 1 m for which the trinomial was chosen
  float fade_start_m;     // blades sink between these distances, beyond which only the flat tier stands
  float fade_end_m;
  float widest_pixels;    // a blade is never widened beyond this many pixels
};
