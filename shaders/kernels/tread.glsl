// The field of a tread: how far a body that moves from P0 to P1 presses down the grass at P (G03 §4.2).
//
//   F(P) = ∫ ds / (r² + ε²)^(3/2)
//   E(P) = F(P) (sign(A·N) N + C)
//
// over the segment; r: distance from P to its points; ε: the body's radius; F in 1/m²; C: unit vector along
// the motion; N: its normal to the left; A = P − P0.
//
// Deviations: G03's closed form is that of ε = 0, which is singular on the path. A body reaches only so far:
// what lies farther from P than a fixed reach is left out of the integral, so that the fields of a pass's
// steps add up to that of the pass whatever the steps are. Positions are relative to P0, so that floats are
// fine; `along_m`, `across_m`: of P, along and to the left of the motion.

// F of a straight path of `length_m` from its start, h² = across² + ε². Beside the path F = (x/r0 + y/r1)/h²
// with x, y the ways from P's foot to its ends. Beyond the ends this is a small difference of large numbers,
// and only there the form L(r0 + r1)/(r0 r1 (r0 r1 + (P0 − P)·(P1 − P) + ε²)) is not.
float tread_of_path(float along_m, float length_m, float h2) {
  precise float ahead_m = length_m - along_m;
  precise float r0 = sqrt(along_m * along_m + h2);
  precise float r1 = sqrt(ahead_m * ahead_m + h2);
  precise float beside = (along_m / r0 + ahead_m / r1) / h2;
  precise float r01 = r0 * r1;
  precise float beyond = length_m * (r0 + r1) / (r01 * (r01 + (h2 - along_m * ahead_m)));
  return min(along_m, ahead_m) >= 0.0f ? beside : beyond;
}

// F, 1/m², of the part of the path that lies within `reach_m` of P.
float tread_field(float along_m, float across_m, float length_m, float radius_m, float reach_m) {
  precise float chord2 = reach_m * reach_m - across_m * across_m;
  precise float half_chord_m = sqrt(max(chord2, 0.0f));
  precise float start_m = max(along_m - half_chord_m, 0.0f);
  precise float end_m = min(along_m + half_chord_m, length_m);
  precise float h2 = across_m * across_m + radius_m * radius_m;
  float field = tread_of_path(along_m - start_m, max(end_m - start_m, 0.0f), h2);
  return end_m > start_m ? field : 0.0f;
}

// F, 1/m², of a body that came to P0 from afar: half of what it leaves behind when it walks on.
float standing_field(float distance_m, float radius_m, float reach_m) {
  precise float chord2 = reach_m * reach_m - distance_m * distance_m;
  precise float h2 = distance_m * distance_m + radius_m * radius_m;
  precise float result = sqrt(max(chord2, 0.0f)) / (h2 * sqrt(reach_m * reach_m + radius_m * radius_m));
  return result;
}

// E/F: outward on both sides, and forward; only forward on the path itself. `forward`: C.
vec2 tread_direction(vec2 forward, float across_m) {
  float side = across_m > 0.0f ? 1.0f : (across_m < 0.0f ? -1.0f : 0.0f);
  precise float x = forward.x - side * forward.y;
  precise float y = forward.y + side * forward.x;
  return vec2(x, y);
}

// How far blades lie down, rad: θmax (1 − e^(−F/F0)). `scale`: F0, in the unit of `field`.
float tread_tilt(float field, float scale, float most_rad) {
  precise float result = most_rad * (1.0f - falling_exponential(field / scale));
  return result;
}
