// Trodden blades (G03 §4.2): feet change the shape at rest itself, a blade stays as it was pressed until it
// has risen. What the field says of a place (animation/tread_node.h) lays the curve of pose_blade towards the
// ground.

// Trodden grass at a root.
struct Pressing {
  vec2 lean_rad;   // how far and where to blades are bent
  float tilt_rad;  // how far they lie down in all; what has no direction lies as it stood
  float wear;      // 0…1
};

Pressing no_pressing() {
  Pressing pressing;
  pressing.lean_rad = vec2(0.0f, 0.0f);
  pressing.tilt_rad = 0.0f;
  pressing.wear = 0.0f;
  return pressing;
}

// 0: as it grew; 1 would be flat on the ground.
float lying_share(Pressing pressing) {
  return min(pressing.tilt_rad * 0.63661975f, 1.0f);
}

// How steeply downhill segments may point, by the sine: lying blades do not sag into the ground, but lie on
// one another.
float lowest_rise(float lying) {
  precise float l2 = lying * lying;
  precise float result = min(lying - 1.0f + 0.26f * l2 * l2, 0.08f);
  return result;
}

// Length that worn grass has left.
float worn_length(float wear) {
  precise float result = 1.0f - 0.35f * wear;
  return result;
}

// A direction that rises at least that steeply over the ground with this normal.
vec3 raised(vec3 direction, vec3 normal, float least_rise) {
  precise vec3 lifted = direction + normal * max(least_rise - inner(direction, normal), 0.0f);
  return normalized(lifted);
}

// `rest`: an arc of that length (pose_blade); `normal`: of the ground.
BladeCurve pressed_curve(BladeCurve rest, float length_m, vec3 normal, Pressing pressing) {
  float lying = lying_share(pressing);
  vec3 d = normalized(rest.base_tangent_m);
  vec3 e = normalized(rest.tip_tangent_m);
  vec3 p = outer(rest.side, d);

  // Where to: with the tread, and a little each to its own side.
  precise float per_tilt = 1.0f / max(pressing.tilt_rad, 1.0e-6f);
  precise vec2 directed = pressing.lean_rad * per_tilt;
  precise float decided = min(sqrt(directed.x * directed.x + directed.y * directed.y), 1.0f);
  precise vec3 own = d + e + p * 0.2f;
  precise vec3 own_level = own - normal * inner(own, normal);
  precise vec3 heading =
      vec3(directed.x, directed.y, 0.0f) + normalized(own_level) * (1.0f - 0.65f * decided);
  precise vec3 level = heading - normal * inner(heading, normal);
  vec3 flat_along = normalized(level);

  precise float upright = 1.0f - lying;
  precise vec3 lifted = e - normal * (min(inner(e, normal), 0.0f) * min(2.0f * lying, 1.0f));
  precise vec3 foot = d * upright + flat_along * lying;
  precise vec3 end = lifted * upright + flat_along * lying;
  vec3 d1 = normalized(foot);
  vec3 e1 = normalized(end);

  // The arc between them. sin h/h ≈ (2 + cos h)/3; tangents as in pose_blade.
  precise float c = sqrt(max(0.5f + 0.5f * inner(d1, e1), 0.0f));
  precise float x = 2.0f - 2.0f * c;
  precise float turning2 = 4.0f * x * (1.0f + x * (0.083333336f + x * 0.011111111f));
  precise float chord_m = length_m * (2.0f + c) * 0.33333334f;
  precise float tangent_m = length_m * (1.0f + turning2 * (0.020833333f + turning2 * 0.00052083333f));
  vec3 chord = normalized(d1 + e1);

  // A blade that has straightened keeps the side that it had, turned along with its foot.
  precise vec3 turned_p = p - (d + d1) * (inner(p, d1) / max(1.0f + inner(d, d1), 1.0e-3f));
  precise vec3 bent = e1 - d1 * inner(d1, e1) + turned_p * 1.0e-3f;
  BladeCurve curve;
  curve.base_m = rest.base_m;
  precise vec3 tip_m = rest.base_m + chord * chord_m;
  precise vec3 base_tangent_m = d1 * tangent_m;
  precise vec3 tip_tangent_m = e1 * tangent_m;
  curve.tip_m = tip_m;
  curve.base_tangent_m = base_tangent_m;
  curve.tip_tangent_m = tip_tangent_m;
  curve.side = normalized(outer(d1, normalized(bent)));
  return curve;
}
