// Which tier stands at a place, as shares in [0, 1] that change smoothly with distance and slant (G03
// §3.4, 3.5). Strips stand only where grass is seen at grazing angles; seen from above, thinned blades stay
// until the flat tier takes over.

// Where a distance lies in the band of 3D blades and strips: 0 at its near end, 1 at its far one.
float strip_band(LodCoefficients lod, float distance_m) {
  return (distance_m - lod.strip_start_m) / (lod.strip_end_m - lod.strip_start_m);
}

// How far strips may stand for a slant: `n_dot_r` of the ground's normal and the direction to the eye.
float strip_grazing(LodCoefficients lod, float n_dot_r) {
  return 1.0f - smooth_ramp((n_dot_r - lod.grazing) / (lod.steep - lod.grazing));
}

// How far a tile has morphed from 3D blades (0) to strips (1).
float strip_morph(LodCoefficients lod, float band, float n_dot_r) {
  return saturate(band) * strip_grazing(lod, n_dot_r);
}

// How far grass has sunk into the flat tier. Deviation: strips thin out, blade by blade, rather than sink;
// where they end they are two or three pixels high, and sinking exchanged a whole row of a strip's pixels at
// once.
float sunk_share(LodCoefficients lod, float distance_m) {
  return smooth_ramp((distance_m - lod.fade_start_m) / (lod.fade_end_m - lod.fade_start_m));
}

// 0: the spline blade; 1: the Hermite blade.
float hermite_share(LodCoefficients lod, float distance_m) {
  return smooth_ramp((distance_m - lod.spline_start_m) / (lod.spline_end_m - lod.spline_start_m));
}

// Strips grow a little before blades leave. The ground can fill in what both leave bare, but not take away
// what both cover.
float strips_grown(float morph) {
  return smooth_ramp(1.12f * morph);
}
float blades_left(float morph) {
  return 1.0f - smooth_ramp(1.12f * morph - 0.12f);
}

// How far the feet of a tile's blades have slid to its nearest edge.
float feet_slid(float morph) {
  return smooth_ramp(morph);
}

// A foot that slides to the nearest edge of its tile. `root_m`: relative to the tile's south-west corner.
vec2 slid_root(vec2 root_m, float tile_m, float morph) {
  precise float west = root_m.x;
  precise float east = tile_m - root_m.x;
  precise float south = root_m.y;
  precise float north = tile_m - root_m.y;
  float nearest_x = west < east ? -west : east;
  float nearest_y = south < north ? -south : north;
  precise vec2 slid = root_m;
  if (abs(nearest_x) < abs(nearest_y)) {
    slid = vec2(root_m.x + feet_slid(morph) * nearest_x, root_m.y);
  } else {
    slid = vec2(root_m.x, root_m.y + feet_slid(morph) * nearest_y);
  }
  return slid;
}
