// The shape of a blade at rest: a Hermite curve from base, tip and two tangents (G03 §3.3). G03 lowers the
// tip as it moves sideways so that the length stays about the same; here base, tip and tangents are those of
// a circular arc of the blade's length, which keeps it within 0.3 % up to a turning of 2 rad.

vec3 normalized(vec3 v) {
  precise float scale = 1.0f / sqrt(max(v.x * v.x + v.y * v.y + v.z * v.z, 1.0e-20f));
  return vec3(v.x * scale, v.y * scale, v.z * scale);
}

float inner(vec3 a, vec3 b) {
  precise float result = a.x * b.x + a.y * b.y + a.z * b.z;
  return result;
}

vec3 outer(vec3 a, vec3 b) {
  precise vec3 result = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return result;
}

// A curve p(t), t ∈ [0, 1], and the direction across the blade.
struct BladeCurve {
  vec3 base_m;
  vec3 tip_m;
  vec3 base_tangent_m;
  vec3 tip_tangent_m;
  vec3 side;
};

// `slope`: (∂z/∂x, ∂z/∂y) of the ground at the root; `growth`: share of its length that the blade shows.
BladeCurve pose_blade(Blade blade, vec2 slope, float growth) {
  vec3 normal = normalized(vec3(-slope.x, -slope.y, 1.0f));
  precise float ca = cosine(blade.azimuth_rad);
  precise float sa = sine(blade.azimuth_rad);
  precise float ct = cosine(blade.tilt_rad);
  precise float st = sine(blade.tilt_rad);
  // The foot: tilted from the normal towards the azimuth, and half of the tuft's lean.
  precise vec3 foot = vec3(ct * normal.x + st * ca + 0.5f * blade.lean.x,
                           ct * normal.y + st * sa + 0.5f * blade.lean.y, ct * normal.z);
  vec3 d = normalized(foot);
  // What bends it: its own curvature towards the azimuth, and the tuft's lean.
  precise vec3 pull =
      vec3(blade.curvature_rad * ca + blade.lean.x, blade.curvature_rad * sa + blade.lean.y, 0.0f);
  precise float along = inner(pull, d);
  precise vec3 across = vec3(pull.x - along * d.x, pull.y - along * d.y, pull.z - along * d.z);
  precise float turning = min(sqrt(inner(across, across)), 2.6f);
  vec3 p = normalized(vec3(across.x + 1.0e-6f * ca, across.y + 1.0e-6f * sa, across.z));

  precise float half_turning = 0.5f * turning;
  float cosine_half = cosine(half_turning);
  float sine_half = sine(half_turning);
  precise float length_m = blade.height_m * growth;
  // Chord of the arc, and the tangent length 4 tan(β/4)/β with which a cubic follows it.
  precise float chord_m = half_turning > 1.0e-3f ? length_m * sine_half / half_turning : length_m;
  precise float b2 = turning * turning;
  precise float tangent_m =
      length_m * (1.0f + b2 * (0.020833333f + b2 * (0.00052083333f + b2 * 0.0000131753f)));
  precise float ce = cosine(turning);
  precise float se = sine(turning);

  BladeCurve curve;
  curve.base_m = vec3(blade.root_m.x, blade.root_m.y, blade.ground_m);
  precise vec3 chord = vec3(cosine_half * d.x + sine_half * p.x, cosine_half * d.y + sine_half * p.y,
                            cosine_half * d.z + sine_half * p.z);
  curve.tip_m = vec3(curve.base_m.x + chord_m * chord.x, curve.base_m.y + chord_m * chord.y,
                     curve.base_m.z + chord_m * chord.z);
  curve.base_tangent_m = vec3(tangent_m * d.x, tangent_m * d.y, tangent_m * d.z);
  curve.tip_tangent_m = vec3(tangent_m * (ce * d.x + se * p.x), tangent_m * (ce * d.y + se * p.y),
                             tangent_m * (ce * d.z + se * p.z));
  curve.side = normalized(outer(d, p));
  return curve;
}
