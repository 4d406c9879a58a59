// Coefficients of the weight function and of the tiers (shaders/kernels/weight.glsl, tiers.glsl). std430 and
// std140.

struct LodCoefficients {
  float a1;  // F's trinomial a1 + a2 d + a3 d² (B11 §2.2); d in metres at the reference pixel
  float a2;
  float a3;
  float fade;             // share of the drawn blades that are still growing in
  float reference_pixel;  // height of a pixel at 1 m for which the trinomial was chosen
  float fade_start_m;     // grass sinks between these distances, beyond which only the flat tier stands
  float fade_end_m;
  float widest_pixels;   // a blade is never widened beyond this many pixels
  float spline_start_m;  // spline blades become Hermite blades between these distances
  float spline_end_m;
  float strip_start_m;  // 3D blades become strips between these distances
  float strip_end_m;
  float grazing;         // n·r up to which strips stand for blades,
  float steep;           // and from which on they never do
  float unthinned;       // 1: every blade is drawn as planted
  float crowded_per_m2;  // of denser swards no more blades are drawn than of one of this density
};
