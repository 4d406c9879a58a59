// Thinning with distance: B11's weight function F(z, φ) (§2.2), n·r at least 0 and α = 8 as printed.
//
// B11 discards blades of weight w < F. Here blade k of N has the rank q = (k + ξ)/N and the weight 1 − q, so
// that the first N · (1 − F) blades of a cell stay (docs/design.md, D2). Deviations: a blade near the
// threshold grows in rather than pops, and the blades that stay are widened so that their area does, up to a
// few pixels. d is the distance at which the reference pixel would be as high as this one, so that a finer
// picture thins later.

// (1 − t)(n·r) + t with t = (1 − |n·r|)^8: the visible size of a piece of ground, and its contours.
float visible_size(float n_dot_r) {
  precise float x = saturate(n_dot_r);
  precise float t = square(square(square(1.0f - x)));
  precise float result = (1.0f - t) * x + t;
  return result;
}

// The keep share that leaves an area: the inverse of area_left.
float keep_leaving(LodCoefficients lod, float area) {
  precise float partly = 1.0f - 0.5f * lod.fade;
  if (area <= partly) return area / partly;
  precise float full = 1.0f - lod.fade;
  precise float half_b = full + lod.fade * (1.0f - min(area, 1.0f));
  precise float root = sqrt(max(square(half_b) - square(full), 0.0f));
  return (half_b - root) / square(full);
}

// Thinned further, blades could not be widened enough to keep their area (widened_m). A little more, for
// blades that are wider than the mean.
float least_share(LodCoefficients lod, float width_m, float pixel_m) {
  return keep_leaving(lod, 1.25f * width_m / (lod.widest_pixels * pixel_m));
}

// 1 − F before it is clamped to 1. `pixel_m`: height of a pixel at the blade; `distance_m`: from the eye;
// `width_m`: mean of the blades.
float keep_share(LodCoefficients lod, float n_dot_r, float pixel_m, float distance_m, float width_m) {
  if (lod.unthinned > 0.5f) return 1.0e6f;
  precise float d = pixel_m / lod.reference_pixel;
  precise float share = visible_size(n_dot_r) / (lod.a1 + d * (lod.a2 + d * lod.a3));
  precise float result =
      max(share, least_share(lod, width_m, pixel_m)) * (1.0f - sunk_share(lod, distance_m));
  return result;
}

// B11's F bounds the number of blades on a piece of the screen, so a dense sward keeps a smaller share of its
// own.
float crowded_share(LodCoefficients lod, float density_per_m2) {
  if (lod.unthinned > 0.5f) return 1.0f;
  return min(lod.crowded_per_m2 / max(density_per_m2, 1.0e-6f), 1.0f);
}

// How far a blade of rank q has grown, 0…1.
float growth_of(LodCoefficients lod, float keep, float rank) {
  precise float growth = (keep - rank) / (lod.fade * keep + 1.0e-12f);
  return saturate(growth);
}

// Mean growth of all planted blades (the integral of growth_of over the ranks): the area left after thinning.
float area_left(LodCoefficients lod, float keep) {
  precise float grown = keep * (1.0f - lod.fade);
  if (grown >= 1.0f) return 1.0f;
  if (keep <= 1.0f) return keep * (1.0f - 0.5f * lod.fade);
  precise float missing = square(1.0f - grown) / (2.0f * lod.fade * keep);
  return 1.0f - missing;
}

// Width of a blade that stands for those left out.
float widened_m(LodCoefficients lod, float keep, float width_m, float pixel_m) {
  precise float wide = width_m / max(area_left(lod, keep), 1.0e-6f);
  return min(wide, max(width_m, lod.widest_pixels * pixel_m));
}
