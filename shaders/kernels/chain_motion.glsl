// The inertial blade: the chain of chain.glsl in motion (B11 §3.1), one step of it.
//
// B11 moves the segments one after the other from the root, J ω̇_i = −g_i + l × T'_i f_i, and so leaves out
// what the segments above do to those below: their weight, and their inertia. Here both stay in. The
// coordinates are the rotation vectors θ_i that turn each segment from its place at rest, as in chain.glsl,
// in world axes and up to π. For thin rods the inertia between two of them depends on nothing but their
// places in the chain as long as it is straight, which makes it a constant 4 × 4 matrix A, and so are those
// of springs and damping, B and C (docs/chains.md has them all):
//   A θ̈ + 2ζν C θ̇ + ν² B θ = (g/l) J_l(θ)ᵀ (t × load),    ν² = k/(m l²) = κ g/l,    C = A (A⁻¹B)^½,
// with l half a segment, m its mass, κ = k/(m g l), t its direction, load as in chain_load. Thereby every
// mode of the chain has the damping ratio ζ; at rest this is the equilibrium of chain_under, so that nothing
// has to be calibrated; and with the transposed left Jacobian J_l of the rotation, weight has a potential:
// without wind energy can only be lost.
//
// Wind, B11 §3.2: k_w |W − v_i|^(γ−1) (W − v_i) at the centre of each segment, γ = 4/3, in weights of a
// segment k_w/(m g) = `drag`; v_i = v*_{i−1} + ω_i × l t_i, v*_i = v*_{i−1} + 2 ω_i × l t_i, which is what
// B11 writes in segment axes.
//
// Integrator: ROS2 (Verwer, Spee, Blom, Hundsdorfer 1999), two linearly implicit stages that share one
// decomposition, of second order for any approximation of the Jacobian. The approximation takes every matrix
// as the same for x, y and z: springs and friction exactly, drag by its secant, the load by the tension
// t·load that straightens a segment (compression counts only down to that by its own weight when upright, so
// that what is decomposed is positive definite). γ = 1 − 1/√2 makes the step L-stable, and accurate: of a
// meadow blade's lowest mode it takes a damping ratio of less than 0.001 at 60 Hz, where an implicit Euler
// step would take 0.1. But what is stiff and not in the Jacobian it may amplify up to −1 times, and so blades
// that the air or their load can throw about within one step take γ = 1 + 1/√2, which is L-stable too and
// never overshoots, |load| for the tension, and a diagonal bound of drag that holds for every shape: |Σ_j
// b_ij ω_j × t_j|² ≤ (Σ_j b_ij) Σ_j b_ij |ω_j|². In both stages a segment turns by at most π, and at most
// that far in a step: what springs cannot hold any more is bounded by that.

// State of a blade: rotation of each segment from its rest direction, rad, and its rate, rad/s.
struct ChainMotion {
  ChainVectors turn;
  ChainVectors rate;
};

struct ChainTraits {
  float half_segment_m;  // l, an eighth of the blade's length
  float stiffness;       // κ; below softest_chain() as that
  float damping_ratio;   // ζ of every mode
  float drag;            // force in weights of a segment in wind of 1 m/s
};

// A state as the air meets it.
struct ChainPose {
  vec4 versine;  // of the segments' turns, see rotation_vector.glsl
  vec4 gap;
  ChainVectors along;  // directions t
  ChainVectors past;   // W − v, m/s
};

// What the surroundings do to a chain in a given state.
struct ChainPull {
  ChainVectors torque;  // J_lᵀ (t × load), in m g l
  vec4 tension;         // t·load, in weights of a segment
  vec4 size;            // |load|
};

float gravity_m_per_s2() {
  return 9.81f;
}

// x^⅙ for x in [1e-20, 1e20], relative error below 5e-5: two of Newton's steps for r = x^−⅙ from a guess by
// the exponent.
float sixth_root(float x) {
  uint bits = floatBitsToUint(x);
  // bits/6 = bits (1/8 + 1/32 + 1/128 + …); the constant is 7/6 of the exponent's bias, less what centres the
  // error.
  uint sixth = (bits >> 3u) + (bits >> 5u) + (bits >> 7u) + (bits >> 9u) + (bits >> 11u) + (bits >> 13u) +
               (bits >> 15u);
  precise float r = uintBitsToFloat(0x4a0df69du - sixth);
  precise float r3 = r * r * r;
  r = r * (1.1666667f - 0.16666667f * x * (r3 * r3));
  r3 = r * r * r;
  r = r * (1.1666667f - 0.16666667f * x * (r3 * r3));
  precise float r2 = r * r;
  precise float result = x * (r2 * r2 * r);
  return result;
}

// The directions of the segments.
ChainVectors chain_directions(ChainVectors rest, ChainVectors turn) {
  ChainVectors along;
  along.v1 = rotated_by(rest.v1, turn.v1);
  along.v2 = rotated_by(rest.v2, turn.v2);
  along.v3 = rotated_by(rest.v3, turn.v3);
  along.v4 = rotated_by(rest.v4, turn.v4);
  return along;
}

ChainVectors within_half_turns(ChainVectors turn) {
  ChainVectors result;
  result.v1 = within_half_turn(turn.v1);
  result.v2 = within_half_turn(turn.v2);
  result.v3 = within_half_turn(turn.v3);
  result.v4 = within_half_turn(turn.v4);
  return result;
}

// B θ, the moments of springs; in units of k.
ChainVectors spring_moments(ChainVectors turn) {
  ChainVectors result;
  precise vec3 bend2 = turn.v2 - turn.v1;
  precise vec3 bend3 = turn.v3 - turn.v2;
  precise vec3 bend4 = turn.v4 - turn.v3;
  precise vec3 moment1 = turn.v1 * 2.0f - bend2;
  precise vec3 moment2 = bend2 - bend3;
  precise vec3 moment3 = bend3 - bend4;
  result.v1 = moment1;
  result.v2 = moment2;
  result.v3 = moment3;
  result.v4 = bend4;
  return result;
}

// C θ̇, the moments of inner friction; in units of 2ζν m l².
ChainVectors friction_moments(ChainVectors rate) {
  ChainVectors result;
  precise vec3 moment1 =
      rate.v1 * 3.7895030f + rate.v2 * 0.96769239f + rate.v3 * 0.16083825f - rate.v4 * 0.0079857817f;
  precise vec3 moment2 =
      rate.v1 * 0.96769239f + rate.v2 * 1.9789349f + rate.v3 * 0.23330230f - rate.v4 * 0.086381062f;
  precise vec3 moment3 =
      rate.v1 * 0.16083825f + rate.v2 * 0.23330230f + rate.v3 * 1.3667001f - rate.v4 * 0.087270376f;
  precise vec3 moment4 =
      rate.v4 * 0.71331635f - rate.v1 * 0.0079857817f - rate.v2 * 0.086381062f - rate.v3 * 0.087270376f;
  result.v1 = moment1;
  result.v2 = moment2;
  result.v3 = moment3;
  result.v4 = moment4;
  return result;
}

// A θ̈, in units of m l².
ChainVectors inertia_moments(ChainVectors acceleration) {
  ChainVectors result;
  precise vec3 moment1 = acceleration.v1 * 13.333333f + acceleration.v2 * 10.0f + acceleration.v3 * 6.0f +
                         acceleration.v4 * 2.0f;
  precise vec3 moment2 = acceleration.v1 * 10.0f + acceleration.v2 * 9.3333333f + acceleration.v3 * 6.0f +
                         acceleration.v4 * 2.0f;
  precise vec3 moment3 =
      (acceleration.v1 + acceleration.v2) * 6.0f + acceleration.v3 * 5.3333333f + acceleration.v4 * 2.0f;
  precise vec3 moment4 =
      (acceleration.v1 + acceleration.v2 + acceleration.v3) * 2.0f + acceleration.v4 * 1.3333333f;
  result.v1 = moment1;
  result.v2 = moment2;
  result.v3 = moment3;
  result.v4 = moment4;
  return result;
}

ChainVectors chain_sum(ChainVectors a, ChainVectors b, float scale) {
  ChainVectors result;
  precise vec3 v1 = a.v1 + b.v1 * scale;
  precise vec3 v2 = a.v2 + b.v2 * scale;
  precise vec3 v3 = a.v3 + b.v3 * scale;
  precise vec3 v4 = a.v4 + b.v4 * scale;
  result.v1 = v1;
  result.v2 = v2;
  result.v3 = v3;
  result.v4 = v4;
  return result;
}

// `wind`: W, m/s.
ChainPose chain_pose(ChainVectors rest, ChainVectors turn, ChainVectors rate, vec3 wind,
                     float half_segment_m) {
  vec4 square = vec4(inner(turn.v1, turn.v1), inner(turn.v2, turn.v2), inner(turn.v3, turn.v3),
                     inner(turn.v4, turn.v4));
  ChainPose pose;
  pose.versine = vec4(versine_share(square.x), versine_share(square.y), versine_share(square.z),
                      versine_share(square.w));
  pose.gap = vec4(sine_gap(square.x), sine_gap(square.y), sine_gap(square.z), sine_gap(square.w));
  pose.along.v1 = rotated(rest.v1, turn.v1, pose.versine.x, pose.gap.x);
  pose.along.v2 = rotated(rest.v2, turn.v2, pose.versine.y, pose.gap.y);
  pose.along.v3 = rotated(rest.v3, turn.v3, pose.versine.z, pose.gap.z);
  pose.along.v4 = rotated(rest.v4, turn.v4, pose.versine.w, pose.gap.w);
  // Half of the velocity that a segment adds is reached at its centre.
  precise vec3 half1 =
      outer(left_jacobian(turn.v1, rate.v1, pose.versine.x, pose.gap.x), pose.along.v1) * half_segment_m;
  precise vec3 half2 =
      outer(left_jacobian(turn.v2, rate.v2, pose.versine.y, pose.gap.y), pose.along.v2) * half_segment_m;
  precise vec3 half3 =
      outer(left_jacobian(turn.v3, rate.v3, pose.versine.z, pose.gap.z), pose.along.v3) * half_segment_m;
  precise vec3 half4 =
      outer(left_jacobian(turn.v4, rate.v4, pose.versine.w, pose.gap.w), pose.along.v4) * half_segment_m;
  precise vec3 past1 = wind - half1;
  precise vec3 past2 = past1 - half1 - half2;
  precise vec3 past3 = past2 - half2 - half3;
  precise vec3 past4 = past3 - half3 - half4;
  pose.past.v1 = past1;
  pose.past.v2 = past2;
  pose.past.v3 = past3;
  pose.past.v4 = past4;
  return pose;
}

// |W − v|^⅓.
vec4 chain_grip(ChainVectors past) {
  return vec4(sixth_root(inner(past.v1, past.v1) + 1.0e-12f), sixth_root(inner(past.v2, past.v2) + 1.0e-12f),
              sixth_root(inner(past.v3, past.v3) + 1.0e-12f), sixth_root(inner(past.v4, past.v4) + 1.0e-12f));
}

// `pressure`: drag · grip per segment.
ChainPull chain_pull(ChainPose pose, ChainVectors turn, vec4 pressure) {
  ChainVectors force;
  precise vec3 force1 = pose.past.v1 * pressure.x - vec3(0.0f, 0.0f, 1.0f);
  precise vec3 force2 = pose.past.v2 * pressure.y - vec3(0.0f, 0.0f, 1.0f);
  precise vec3 force3 = pose.past.v3 * pressure.z - vec3(0.0f, 0.0f, 1.0f);
  precise vec3 force4 = pose.past.v4 * pressure.w - vec3(0.0f, 0.0f, 1.0f);
  force.v1 = force1;
  force.v2 = force2;
  force.v3 = force3;
  force.v4 = force4;
  ChainVectors load = chain_load(force);
  // The transposed Jacobian is that of the opposite rotation.
  ChainPull pull;
  pull.torque.v1 = left_jacobian(turn.v1, outer(pose.along.v1, load.v1), -pose.versine.x, pose.gap.x);
  pull.torque.v2 = left_jacobian(turn.v2, outer(pose.along.v2, load.v2), -pose.versine.y, pose.gap.y);
  pull.torque.v3 = left_jacobian(turn.v3, outer(pose.along.v3, load.v3), -pose.versine.z, pose.gap.z);
  pull.torque.v4 = left_jacobian(turn.v4, outer(pose.along.v4, load.v4), -pose.versine.w, pose.gap.w);
  pull.tension = vec4(inner(pose.along.v1, load.v1), inner(pose.along.v2, load.v2),
                      inner(pose.along.v3, load.v3), inner(pose.along.v4, load.v4));
  pull.size = vec4(sqrt(inner(load.v1, load.v1)), sqrt(inner(load.v2, load.v2)),
                   sqrt(inner(load.v3, load.v3)), sqrt(inner(load.v4, load.v4)));
  return pull;
}

// A + γh (2ζν C + D) + γ²h² (ν² B + g/l · stiffening), decomposed; `gh` = γh. D_jk = g Σ_i pressure_i b_ij
// b_ik t_j·t_k with b = 2 below a segment and 1 in it: exact for turns in a plane. `safety` 1: the diagonal
// bound.
ChainMatrix chain_matrix(float weight_per_s2, float spring_per_s2, float friction_per_s, vec4 stiffening,
                         vec4 pressure, ChainVectors along, float safety, float gh) {
  precise float c = gh * friction_per_s;
  precise float b = gh * gh * spring_per_s2;
  precise float weight = gh * gh * weight_per_s2;
  precise vec4 drag = pressure * (gh * gravity_m_per_s2());
  precise float above3 = 4.0f * drag.w;
  precise float above2 = above3 + 4.0f * drag.z;
  precise float above1 = above2 + 4.0f * drag.y;
  precise float drag1 = drag.x + above1 + safety * (2.0f * drag.y + 6.0f * drag.z + 10.0f * drag.w);
  precise float drag2 = drag.y + above2 + safety * (2.0f * drag.y + 6.0f * drag.z + 10.0f * drag.w);
  precise float drag3 = drag.z + above3 + safety * (4.0f * drag.z + 10.0f * drag.w);
  precise float drag4 = drag.w + safety * (6.0f * drag.w);
  precise float joint = 1.0f - safety;
  precise float joint2 = joint * (2.0f * drag.y + above2);
  precise float joint3 = joint * (2.0f * drag.z + above3);
  precise float joint4 = joint * (2.0f * drag.w);
  ChainMatrix m;
  precise float m11 = 13.333333f + 3.7895030f * c + 3.0f * b + drag1 + weight * stiffening.x;
  precise float m12 = 10.0f + 0.96769239f * c - b + joint2 * inner(along.v1, along.v2);
  precise float m13 = 6.0f + 0.16083825f * c + joint3 * inner(along.v1, along.v3);
  precise float m14 = 2.0f - 0.0079857817f * c + joint4 * inner(along.v1, along.v4);
  precise float m22 = 9.3333333f + 1.9789349f * c + 2.0f * b + drag2 + weight * stiffening.y;
  precise float m23 = 6.0f + 0.23330230f * c - b + joint3 * inner(along.v2, along.v3);
  precise float m24 = 2.0f - 0.086381062f * c + joint4 * inner(along.v2, along.v4);
  precise float m33 = 5.3333333f + 1.3667001f * c + 2.0f * b + drag3 + weight * stiffening.z;
  precise float m34 = 2.0f - 0.087270376f * c - b + joint4 * inner(along.v3, along.v4);
  precise float m44 = 1.3333333f + 0.71331635f * c + b + drag4 + weight * stiffening.w;
  m.m11 = m11;
  m.m12 = m12;
  m.m13 = m13;
  m.m14 = m14;
  m.m22 = m22;
  m.m23 = m23;
  m.m24 = m24;
  m.m33 = m33;
  m.m34 = m34;
  m.m44 = m44;
  return decomposed(m);
}

// θ̈ without inertia's inverse: (g/l) torque − ν² B θ − 2ζν C θ̇, 1/s².
ChainVectors chain_drive(ChainVectors turn, ChainVectors rate, ChainVectors torque, float weight_per_s2,
                         float spring_per_s2, float friction_per_s) {
  ChainVectors springs = spring_moments(turn);
  ChainVectors friction = friction_moments(rate);
  ChainVectors drive;
  precise vec3 drive1 = torque.v1 * weight_per_s2 - springs.v1 * spring_per_s2 - friction.v1 * friction_per_s;
  precise vec3 drive2 = torque.v2 * weight_per_s2 - springs.v2 * spring_per_s2 - friction.v2 * friction_per_s;
  precise vec3 drive3 = torque.v3 * weight_per_s2 - springs.v3 * spring_per_s2 - friction.v3 * friction_per_s;
  precise vec3 drive4 = torque.v4 * weight_per_s2 - springs.v4 * spring_per_s2 - friction.v4 * friction_per_s;
  drive.v1 = drive1;
  drive.v2 = drive2;
  drive.v3 = drive3;
  drive.v4 = drive4;
  return drive;
}

// One stage: the change of `rate` for the drive `right` and the change of turn `way`, both over the step.
ChainVectors chain_stage(ChainMatrix matrix, ChainVectors right, ChainVectors way, vec4 stiffening,
                         float weight_per_s2, float spring_per_s2, float gh) {
  ChainVectors springs = spring_moments(way);
  precise float spring = gh * spring_per_s2;
  precise vec4 weight = stiffening * (gh * weight_per_s2);
  ChainVectors side;
  precise vec3 side1 = right.v1 - springs.v1 * spring - way.v1 * weight.x;
  precise vec3 side2 = right.v2 - springs.v2 * spring - way.v2 * weight.y;
  precise vec3 side3 = right.v3 - springs.v3 * spring - way.v3 * weight.z;
  precise vec3 side4 = right.v4 - springs.v4 * spring - way.v4 * weight.w;
  side.v1 = side1;
  side.v2 = side2;
  side.v3 = side3;
  side.v4 = side4;
  return solved(matrix, side);
}

ChainVectors chain_scaled(ChainVectors a, float scale) {
  ChainVectors result;
  precise vec3 v1 = a.v1 * scale;
  precise vec3 v2 = a.v2 * scale;
  precise vec3 v3 = a.v3 * scale;
  precise vec3 v4 = a.v4 * scale;
  result.v1 = v1;
  result.v2 = v2;
  result.v3 = v3;
  result.v4 = v4;
  return result;
}

// A blade after `dt_s` in wind W (m/s, constant over blade and step). `rest`: directions of its relaxed
// segments.
ChainMotion chain_after(ChainMotion now, ChainVectors rest, ChainTraits traits, vec3 wind, float dt_s) {
  precise float weight_per_s2 = gravity_m_per_s2() / traits.half_segment_m;
  precise float spring_per_s2 = max(traits.stiffness, softest_chain()) * weight_per_s2;
  precise float friction_per_s = 2.0f * traits.damping_ratio * sqrt(spring_per_s2);
  ChainPose pose = chain_pose(rest, now.turn, now.rate, wind, traits.half_segment_m);
  precise vec4 pressure = chain_grip(pose.past) * traits.drag;
  ChainPull pull = chain_pull(pose, now.turn, pressure);
  // Whether one step can turn it by half a radian: for its rate, its load on the inertia of all that hangs on
  // the root, or the air that carries it along.
  precise float fastest = max(max(inner(now.rate.v1, now.rate.v1), inner(now.rate.v2, now.rate.v2)),
                              max(inner(now.rate.v3, now.rate.v3), inner(now.rate.v4, now.rate.v4)));
  precise float surge =
      max(0.15f * dt_s * dt_s * weight_per_s2 * pull.size.x, 6.0f * dt_s * gravity_m_per_s2() * pressure.w);
  bool surges = max(surge, 4.0f * dt_s * dt_s * fastest) > 1.0f;
  precise float gh = (surges ? 1.7071068f : 0.29289322f) * dt_s;
  precise float straight1 = max(pull.tension.x, -7.0f);
  precise float straight2 = max(pull.tension.y, -5.0f);
  precise float straight3 = max(pull.tension.z, -3.0f);
  precise float straight4 = max(pull.tension.w, -1.0f);
  vec4 stiffening = vec4(surges ? pull.size.x : straight1, surges ? pull.size.y : straight2,
                         surges ? pull.size.z : straight3, surges ? pull.size.w : straight4);
  ChainMatrix matrix = chain_matrix(weight_per_s2, spring_per_s2, friction_per_s, stiffening, pressure,
                                    pose.along, surges ? 1.0f : 0.0f, gh);

  ChainVectors drive =
      chain_drive(now.turn, now.rate, pull.torque, weight_per_s2, spring_per_s2, friction_per_s);
  ChainVectors way = chain_scaled(now.rate, dt_s);
  ChainVectors rate1 =
      chain_stage(matrix, chain_scaled(drive, dt_s), way, stiffening, weight_per_s2, spring_per_s2, gh);
  ChainVectors turn1 = chain_sum(way, rate1, gh);

  ChainVectors rate_there = chain_sum(now.rate, rate1, 1.0f);
  ChainVectors turn_there = chain_sum(now.turn, turn1, 1.0f);
  ChainVectors bounded_turn = within_half_turns(turn_there);
  pose = chain_pose(rest, bounded_turn, rate_there, wind, traits.half_segment_m);
  pull = chain_pull(pose, bounded_turn, pressure);
  drive = chain_drive(turn_there, rate_there, pull.torque, weight_per_s2, spring_per_s2, friction_per_s);
  way = chain_sum(chain_scaled(rate_there, dt_s), turn1, -2.0f);
  ChainVectors right = chain_sum(chain_scaled(drive, dt_s), inertia_moments(rate1), -2.0f);
  ChainVectors rate2 = chain_stage(matrix, right, way, stiffening, weight_per_s2, spring_per_s2, gh);
  ChainVectors turn2 = chain_sum(way, rate2, gh);

  ChainMotion next;
  // Faster than half a turn per step is nothing that a step could follow.
  ChainVectors rate = chain_sum(chain_sum(now.rate, rate1, 1.5f), rate2, 0.5f);
  next.rate = chain_scaled(within_half_turns(chain_scaled(rate, dt_s)), 1.0f / dt_s);
  ChainVectors turn = chain_sum(chain_sum(now.turn, turn1, 1.5f), turn2, 0.5f);
  next.turn = within_half_turns(turn);
  return next;
}

// The direction in which a blade leaves the ground. A joint has half a radian for the half segment that
// sticks in it; a foot that is bent further kinks, up to lying on the ground with the lowest segment,
// `first`.
vec3 bent_foot(vec3 foot, vec3 first) {
  precise float c = inner(foot, first);
  vec3 across = normalized(foot - first * c);
  // From cos ½ down the angle that stays falls from ½ to nothing at a right angle.
  precise float kept = 0.5f * min(max(c * 1.1394939f, 0.0f), 1.0f);
  precise float kept2 = kept * kept;
  precise float sine_kept = kept * (1.0f - kept2 * (0.16666667f - kept2 * 0.0083333333f));
  precise float cosine_kept = 1.0f - kept2 * (0.5f - kept2 * (0.041666668f - kept2 * 0.0013888889f));
  precise vec3 kinked = first * cosine_kept + across * sine_kept;
  return c >= 0.87758256f ? foot : kinked;
}

// A blade whose segments are turned out of their places at rest, over ground with this normal; its directions
// rise at least by `least_rise` (lowest_rise; −1: hang as they like).
BladeChain turned_chain_over(Blade blade, BladeCurve rest, float growth, ChainVectors turn, vec3 normal,
                             float least_rise) {
  ChainRest relaxed = chain_rest(rest);
  ChainVectors along = chain_directions(relaxed.along, turn);
  vec3 end = rotated_by(relaxed.end, turn.v4);
  along.v1 = raised(along.v1, normal, least_rise);
  along.v2 = raised(along.v2, normal, least_rise);
  along.v3 = raised(along.v3, normal, least_rise);
  along.v4 = raised(along.v4, normal, least_rise);
  end = raised(end, normal, least_rise);
  precise float length_m = blade.height_m * growth;
  BladeChain chain = chain_through(rest, bent_foot(relaxed.foot, along.v1), along, end, length_m);
  // A blade that is bent sideways turns its breadth with its middle, so that it is nowhere along the blade.
  precise vec3 middle = (turn.v2 + turn.v3) * 0.5f;
  chain.side = rotated_by(rest.side, middle);
  return chain;
}

BladeChain turned_chain(Blade blade, BladeCurve rest, float growth, ChainVectors turn) {
  return turned_chain_over(blade, rest, growth, turn, vec3(0.0f, 0.0f, 1.0f), -1.0f);
}
