// The spline blade: a chain of four equal segments that hangs in equilibrium, and the cubic spline through
// its joints (B11 §2.1, §3.1). Rest shape: the arc of pose_blade, springs relaxed. A joint stands for the
// bending of the half segments on either side of it; the lowest has only one, the other being in the ground,
// and so half the rest angle and twice the spring constant. Then the foot stays in its direction, and the
// chain buckles where a beam does. Lengths are in half segments l, forces in weights m g of a segment,
// `stiffness` is k/(m g l). In equilibrium the equations of §3.1 reduce to k_i ψ_i = Σ_{j≥i} (c_j − r_i) ×
// f_j: unlike B11's simplified chain this keeps the weight of the segments above, without which a chain sags
// 10 to 30 times too little. Deviations: the rotation of a segment out of its place at rest is the sum of the
// rotation vectors of the joints below it, exact in a plane; elsewhere it leaves out that rotations do not
// commute. Two corrected fixed-point steps stand for the solution: they are as close as three plain ones. The
// tip is off by at most 0.4 % of the length for stiffness 60 and by 1.5 % for 40, for upright blades a third
// of that. Blades softer than softest_chain() hang as if they had that stiffness, since upright ones would
// buckle. Joints lie closer than a quarter of the blade's length by what the curve through them is longer
// than its chords.

// The joints, and the derivatives there of the spline by its parameter u, which grows by ¼ from joint to
// joint.
struct BladeChain {
  vec3 p0;
  vec3 p1;
  vec3 p2;
  vec3 p3;
  vec3 p4;
  vec3 m0;
  vec3 m1;
  vec3 m2;
  vec3 m3;
  vec3 m4;
  vec3 side;
};

// A vector for each segment, bottom-up.
struct ChainVectors {
  vec3 v1;
  vec3 v2;
  vec3 v3;
  vec3 v4;
};

// v turned by a rotation vector; exact to 1e-4 rad up to 1 rad, and never by more than π. With b = tan(|a|/2)
// a/|a| it is v + 2/(1 + b²) b × (v + b × v).
vec3 turned(vec3 v, vec3 rotation) {
  precise float a2 = inner(rotation, rotation);
  precise float half_tangent = 0.5f + a2 * (0.041666668f + a2 * 0.0041666667f);
  precise vec3 b = rotation * half_tangent;
  precise float scale = 2.0f / (1.0f + a2 * half_tangent * half_tangent);
  precise vec3 halfway = v + outer(b, v);
  precise vec3 result = v + outer(b, halfway) * scale;
  return result;
}

// What turns each segment about its lower joint, given the forces on the segments: half of its own, at its
// centre, and all of those above it, at its end; times its direction, in half segments, this is its share of
// all moments below.
ChainVectors chain_load(ChainVectors force) {
  ChainVectors load;
  precise vec3 above3 = force.v4;
  precise vec3 above2 = above3 + force.v3;
  precise vec3 above1 = above2 + force.v2;
  load.v4 = force.v4;
  precise vec3 load3 = force.v3 + above3 * 2.0f;
  precise vec3 load2 = force.v2 + above2 * 2.0f;
  precise vec3 load1 = force.v1 + above1 * 2.0f;
  load.v3 = load3;
  load.v2 = load2;
  load.v1 = load1;
  return load;
}

// The rotations of the segments that a shape's moments would hold.
ChainVectors chain_response(ChainVectors shape, ChainVectors load, float compliance) {
  vec3 moment4 = outer(shape.v4, load.v4);
  precise vec3 moment3 = moment4 + outer(shape.v3, load.v3);
  precise vec3 moment2 = moment3 + outer(shape.v2, load.v2);
  precise vec3 moment1 = moment2 + outer(shape.v1, load.v1);
  precise vec3 turn1 = moment1 * (0.5f * compliance);
  precise vec3 turn2 = turn1 + moment2 * compliance;
  precise vec3 turn3 = turn2 + moment3 * compliance;
  precise vec3 turn4 = turn3 + moment4 * compliance;
  ChainVectors turns;
  turns.v1 = turn1;
  turns.v2 = turn2;
  turns.v3 = turn3;
  turns.v4 = turn4;
  return turns;
}

ChainVectors chain_turned(ChainVectors rest, ChainVectors turns) {
  ChainVectors shape;
  shape.v1 = turned(rest.v1, turns.v1);
  shape.v2 = turned(rest.v2, turns.v2);
  shape.v3 = turned(rest.v3, turns.v3);
  shape.v4 = turned(rest.v4, turns.v4);
  return shape;
}

float softest_chain() {
  return 20.0f;
}

// One step towards the rotations that hold the shape that they make. A rotation δ of everything changes the
// moment of a load w on t by (δ × t) × w = −(t·w) δ for δ ⊥ w, so that a plain step falls short by a constant
// share, or overshoots where the blade hangs down; the gain makes up for it. Upright and for little sag its
// factor would be 16.9/16, 16.9 being the stiffness at which an upright chain buckles and 16 the sum of the
// loads; blades lower as they bend, and 0.75 leaves the least error after two steps.
ChainVectors chain_step(ChainVectors turns, ChainVectors shape, ChainVectors load, float compliance) {
  precise float raised = -(inner(shape.v1, load.v1) + inner(shape.v2, load.v2) + inner(shape.v3, load.v3) +
                           inner(shape.v4, load.v4));
  precise float gain = 1.0f / max(1.0f - 0.75f * compliance * raised, 0.4f);
  ChainVectors held = chain_response(shape, load, compliance);
  precise vec3 turn1 = turns.v1 + (held.v1 - turns.v1) * gain;
  precise vec3 turn2 = turns.v2 + (held.v2 - turns.v2) * gain;
  precise vec3 turn3 = turns.v3 + (held.v3 - turns.v3) * gain;
  precise vec3 turn4 = turns.v4 + (held.v4 - turns.v4) * gain;
  ChainVectors result;
  result.v1 = turn1;
  result.v2 = turn2;
  result.v3 = turn3;
  result.v4 = turn4;
  return result;
}

// A blade with relaxed springs: the directions of its foot and its segments, and of the arc's end at the tip.
struct ChainRest {
  vec3 foot;
  ChainVectors along;
  vec3 end;
};

ChainRest chain_rest(BladeCurve rest) {
  // Directions of foot and chord, which are half the arc's turning apart, and by halving twice those of the
  // segments.
  vec3 d = normalized(rest.base_tangent_m);
  vec3 p = outer(rest.side, d);
  vec3 chord = normalized(rest.tip_m - rest.base_m);
  precise float c_half = inner(chord, d);
  precise float s_half = inner(chord, p);
  precise float c_joint = sqrt(max(0.5f + 0.5f * c_half, 0.1f));
  precise float s_joint = 0.5f * s_half / c_joint;
  precise float c1 = sqrt(0.5f + 0.5f * c_joint);
  precise float s1 = 0.5f * s_joint / c1;
  precise float c2 = c1 * c_joint - s1 * s_joint;
  precise float s2 = s1 * c_joint + c1 * s_joint;
  precise float c3 = c2 * c_joint - s2 * s_joint;
  precise float s3 = s2 * c_joint + c2 * s_joint;
  precise float c4 = c3 * c_joint - s3 * s_joint;
  precise float s4 = s3 * c_joint + c3 * s_joint;
  precise float c_end = c4 * c1 - s4 * s1;
  precise float s_end = s4 * c1 + c4 * s1;
  precise vec3 rest1 = d * c1 + p * s1;
  precise vec3 rest2 = d * c2 + p * s2;
  precise vec3 rest3 = d * c3 + p * s3;
  precise vec3 rest4 = d * c4 + p * s4;
  precise vec3 rest_end = d * c_end + p * s_end;
  ChainRest result;
  result.foot = d;
  result.along.v1 = rest1;
  result.along.v2 = rest2;
  result.along.v3 = rest3;
  result.along.v4 = rest4;
  result.end = rest_end;
  return result;
}

// The rotations of the segments that hold a load (chain_load), in weights of a segment.
ChainVectors chain_turns(ChainVectors relaxed, ChainVectors load, float compliance) {
  ChainVectors turns;
  turns.v1 = vec3(0.0f, 0.0f, 0.0f);
  turns.v2 = turns.v1;
  turns.v3 = turns.v1;
  turns.v4 = turns.v1;
  turns = chain_step(turns, relaxed, load, compliance);
  ChainVectors shape = chain_turned(relaxed, turns);
  return chain_step(turns, shape, load, compliance);
}

// The curve through a chain of this shape; `d` and `end` are its directions at root and tip.
BladeChain chain_through(BladeCurve rest, vec3 d, ChainVectors shape, vec3 end, float length_m) {
  // A curve of length s that turns by τ has a chord of s (1 − τ²/24); the mean square of the four segments'
  // turnings by the trapezoidal rule from those at the joints, |Δt|² = 2 − 2 t·t'.
  precise float bends = inner(shape.v1, shape.v2) + inner(shape.v2, shape.v3) + inner(shape.v3, shape.v4);
  precise float turning2 = 3.5f - inner(d, shape.v1) - 0.5f * bends - inner(shape.v4, end);
  precise float segment_m = 0.25f * length_m * (1.0f - turning2 * 0.041666668f);

  // Clamped cubic spline: m_{i−1} + 4 m_i + m_{i+1} = 12 (p_{i+1} − p_{i−1}).
  BladeChain chain;
  chain.side = rest.side;
  precise vec3 m0 = d * length_m;
  precise vec3 m4 = end * length_m;
  precise float twelve_m = 12.0f * segment_m;
  precise vec3 right1 = (shape.v1 + shape.v2) * twelve_m - m0;
  precise vec3 right2 = (shape.v2 + shape.v3) * twelve_m;
  precise vec3 right3 = (shape.v3 + shape.v4) * twelve_m - m4;
  precise vec3 m2 = (right2 * 4.0f - right1 - right3) * 0.071428575f;
  precise vec3 m1 = (right1 - m2) * 0.25f;
  precise vec3 m3 = (right3 - m2) * 0.25f;
  chain.m0 = m0;
  chain.m1 = m1;
  chain.m2 = m2;
  chain.m3 = m3;
  chain.m4 = m4;
  chain.p0 = rest.base_m;
  precise vec3 p1 = rest.base_m + shape.v1 * segment_m;
  precise vec3 p2 = p1 + shape.v2 * segment_m;
  precise vec3 p3 = p2 + shape.v3 * segment_m;
  precise vec3 p4 = p3 + shape.v4 * segment_m;
  chain.p1 = p1;
  chain.p2 = p2;
  chain.p3 = p3;
  chain.p4 = p4;
  return chain;
}

// The chain under a force on each segment, in weights of a segment.
BladeChain chain_under(Blade blade, BladeCurve rest, float growth, ChainVectors force) {
  ChainRest relaxed = chain_rest(rest);
  float compliance = 1.0f / max(blade.stiffness, softest_chain());
  ChainVectors turns = chain_turns(relaxed.along, chain_load(force), compliance);
  ChainVectors shape = chain_turned(relaxed.along, turns);
  // No moment acts on the tip: what bends beyond the middle of the uppermost segment is the rest shape.
  vec3 end = turned(relaxed.end, turns.v4);
  precise float length_m = blade.height_m * growth;
  return chain_through(rest, relaxed.foot, shape, end, length_m);
}

// The chain in calm air.
BladeChain chain_of(Blade blade, BladeCurve rest, float growth) {
  ChainVectors weight;
  weight.v1 = vec3(0.0f, 0.0f, -1.0f);
  weight.v2 = weight.v1;
  weight.v3 = weight.v1;
  weight.v4 = weight.v1;
  return chain_under(blade, rest, growth, weight);
}

// The Hermite blade of the same pose. Its tangents are as long as brings the middle of the curve closest to
// that of the chain: h(½) = (p0 + p4)/2 + (m0 − m4) T/8. On an arc that is pose_blade's T = 4 tan(θ/4)/θ.
BladeCurve curve_of(BladeChain chain) {
  precise vec3 bow = (chain.m0 - chain.m4) * 0.125f;
  precise vec3 sag = chain.p2 - (chain.p0 + chain.p4) * 0.5f;
  // A straight blade's tangents keep their length.
  precise float still = 1.0e-5f * inner(chain.m0, chain.m0) + 1.0e-30f;
  precise float stretch = min(max((inner(bow, sag) + still) / (inner(bow, bow) + still), 0.5f), 1.6f);
  precise vec3 base_tangent_m = chain.m0 * stretch;
  precise vec3 tip_tangent_m = chain.m4 * stretch;
  BladeCurve curve;
  curve.base_m = chain.p0;
  curve.tip_m = chain.p4;
  curve.base_tangent_m = base_tangent_m;
  curve.tip_tangent_m = tip_tangent_m;
  curve.side = chain.side;
  return curve;
}

// `hermite_share` 0: the chain; 1: the same curve as curve_of(chain), so that a blade changes tier unseen.
BladeChain blended_chain(BladeChain chain, float hermite_share) {
  BladeCurve curve = curve_of(chain);
  // Hermite's basis and its derivatives at ¼, ½ and ¾.
  precise vec3 way = curve.tip_m - curve.base_m;
  precise vec3 q1 =
      curve.base_m + way * 0.15625f + curve.base_tangent_m * 0.140625f - curve.tip_tangent_m * 0.046875f;
  precise vec3 q2 = curve.base_m + way * 0.5f + (curve.base_tangent_m - curve.tip_tangent_m) * 0.125f;
  precise vec3 q3 =
      curve.base_m + way * 0.84375f + curve.base_tangent_m * 0.046875f - curve.tip_tangent_m * 0.140625f;
  precise vec3 n1 = way * 1.125f + curve.base_tangent_m * 0.1875f - curve.tip_tangent_m * 0.3125f;
  precise vec3 n2 = way * 1.5f - (curve.base_tangent_m + curve.tip_tangent_m) * 0.25f;
  precise vec3 n3 = way * 1.125f - curve.base_tangent_m * 0.3125f + curve.tip_tangent_m * 0.1875f;
  precise vec3 p1 = chain.p1 + (q1 - chain.p1) * hermite_share;
  precise vec3 p2 = chain.p2 + (q2 - chain.p2) * hermite_share;
  precise vec3 p3 = chain.p3 + (q3 - chain.p3) * hermite_share;
  precise vec3 m0 = chain.m0 + (curve.base_tangent_m - chain.m0) * hermite_share;
  precise vec3 m1 = chain.m1 + (n1 - chain.m1) * hermite_share;
  precise vec3 m2 = chain.m2 + (n2 - chain.m2) * hermite_share;
  precise vec3 m3 = chain.m3 + (n3 - chain.m3) * hermite_share;
  precise vec3 m4 = chain.m4 + (curve.tip_tangent_m - chain.m4) * hermite_share;
  BladeChain blended = chain;
  blended.p1 = p1;
  blended.p2 = p2;
  blended.p3 = p3;
  blended.m0 = m0;
  blended.m1 = m1;
  blended.m2 = m2;
  blended.m3 = m3;
  blended.m4 = m4;
  return blended;
}

// The piece of the spline that holds u: as a Hermite curve by t = 4u − i.
BladeCurve chain_piece(BladeChain chain, float u) {
  bool upper = u >= 0.5f;
  bool second = u >= (upper ? 0.75f : 0.25f);
  BladeCurve piece;
  piece.base_m = upper ? (second ? chain.p3 : chain.p2) : (second ? chain.p1 : chain.p0);
  piece.tip_m = upper ? (second ? chain.p4 : chain.p3) : (second ? chain.p2 : chain.p1);
  vec3 base_slope = upper ? (second ? chain.m3 : chain.m2) : (second ? chain.m1 : chain.m0);
  vec3 tip_slope = upper ? (second ? chain.m4 : chain.m3) : (second ? chain.m2 : chain.m1);
  piece.base_tangent_m = base_slope * 0.25f;
  piece.tip_tangent_m = tip_slope * 0.25f;
  piece.side = chain.side;
  return piece;
}

float chain_piece_t(float u) {
  float t = 4.0f * u;
  return t - min(max(floor(t), 0.0f), 3.0f);
}

vec3 chain_point(BladeChain chain, float u) {
  BladeCurve piece = chain_piece(chain, u);
  return hermite_point(piece.base_m, piece.tip_m, piece.base_tangent_m, piece.tip_tangent_m,
                       chain_piece_t(u));
}

vec3 chain_derivative(BladeChain chain, float u) {
  BladeCurve piece = chain_piece(chain, u);
  precise vec3 result = hermite_derivative(piece.base_m, piece.tip_m, piece.base_tangent_m,
                                           piece.tip_tangent_m, chain_piece_t(u)) *
                        4.0f;
  return result;
}
