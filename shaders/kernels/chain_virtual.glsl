// The virtually-inertial blade (B11 §3.3): a blade that moves as if it had inertia, though nothing is stored
// of it. In the middle of each texel of a grid stands a virtual blade, upright, straight, of its species'
// mean length and stiffness, that moves inertially (chain_motion.glsl). What wind, inertia and friction do to
// it at a moment is what would hold it in its shape of that moment if it stood still. Drawn blades stand
// still under that and under their own weight. Deviations. B11 keeps the moments m_i = k_i ψ_i − l × T'_i G
// in segment axes; kept here are the forces that make them, as loads (chain_load) in world axes: a blade that
// leans with the wind then feels it less, as it does in the inertial model. Moments tell of a load only what
// is across its segment; along it acts the wind alone. Loads are divided by the virtual blade's κ, so that
// they bend stiff and soft blades of a species alike, as B11's moments do. Weight of upper segments stays in,
// as everywhere here. B11's three iterations for one segment after the other are three of Newton's steps for
// all of them; ten more bring tips no nearer to those of inertial blades.

// The part of `air` along t, and what of the moment weight does not hold: t × load = moment − t × (0, 0,
// −weight).
vec3 held_load(vec3 t, vec3 moment, vec3 air, float weight) {
  precise vec3 missing = moment + outer(t, vec3(0.0f, 0.0f, weight));
  precise vec3 load = outer(missing, t) + t * inner(air, t);
  return load;
}

// Loads over κ that hold a moving chain of stiffness κ in its shape. `turn`, `rate`: its state, in wind W,
// m/s.
ChainVectors virtual_load(ChainVectors rest, ChainMotion motion, ChainTraits traits, vec3 wind) {
  ChainPose pose = chain_pose(rest, motion.turn, motion.rate, wind, traits.half_segment_m);
  precise float compliance = 1.0f / max(traits.stiffness, softest_chain());
  precise vec4 pressure = chain_grip(pose.past) * (traits.drag * compliance);
  ChainVectors force;
  precise vec3 force1 = pose.past.v1 * pressure.x;
  precise vec3 force2 = pose.past.v2 * pressure.y;
  precise vec3 force3 = pose.past.v3 * pressure.z;
  precise vec3 force4 = pose.past.v4 * pressure.w;
  force.v1 = force1;
  force.v2 = force2;
  force.v3 = force3;
  force.v4 = force4;
  ChainVectors air = chain_load(force);
  ChainVectors springs = spring_moments(motion.turn);
  ChainVectors load;
  load.v1 = held_load(pose.along.v1, springs.v1, air.v1, 7.0f * compliance);
  load.v2 = held_load(pose.along.v2, springs.v2, air.v2, 5.0f * compliance);
  load.v3 = held_load(pose.along.v3, springs.v3, air.v3, 3.0f * compliance);
  load.v4 = held_load(pose.along.v4, springs.v4, air.v4, compliance);
  return load;
}

// One of Newton's steps to equilibrium, with the Jacobian of chain_motion.glsl: (B + tension) δ = t × load −
// B θ, load being over κ. The matrix has three diagonals. Tension is at least `least` times (7, 5, 3, 1), as
// upright under weight, and is taken for more by `caution` times the load.
ChainVectors equilibrium_step(ChainVectors rest, ChainVectors turn, ChainVectors load, float least,
                              float caution) {
  ChainVectors along = chain_directions(rest, turn);
  ChainVectors springs = spring_moments(turn);
  precise float tension1 =
      max(inner(along.v1, load.v1), least * 7.0f) + caution * sqrt(inner(load.v1, load.v1));
  precise float tension2 =
      max(inner(along.v2, load.v2), least * 5.0f) + caution * sqrt(inner(load.v2, load.v2));
  precise float tension3 =
      max(inner(along.v3, load.v3), least * 3.0f) + caution * sqrt(inner(load.v3, load.v3));
  precise float tension4 = max(inner(along.v4, load.v4), least) + caution * sqrt(inner(load.v4, load.v4));
  precise vec3 right1 = outer(along.v1, load.v1) - springs.v1;
  precise vec3 right2 = outer(along.v2, load.v2) - springs.v2;
  precise vec3 right3 = outer(along.v3, load.v3) - springs.v3;
  precise vec3 right4 = outer(along.v4, load.v4) - springs.v4;
  // Off the diagonal stands −1; elimination from the tip down.
  precise float d4 = 1.0f / (1.0f + tension4);
  precise float d3 = 1.0f / (2.0f + tension3 - d4);
  precise float d2 = 1.0f / (2.0f + tension2 - d3);
  precise float d1 = 1.0f / (3.0f + tension1 - d2);
  precise vec3 sum3 = right3 + right4 * d4;
  precise vec3 sum2 = right2 + sum3 * d3;
  precise vec3 sum1 = right1 + sum2 * d2;
  precise vec3 step1 = sum1 * d1;
  precise vec3 step2 = (sum2 + step1) * d2;
  precise vec3 step3 = (sum3 + step2) * d3;
  precise vec3 step4 = (right4 + step3) * d4;
  ChainVectors next;
  next.v1 = within_half_turn(turn.v1 + step1);
  next.v2 = within_half_turn(turn.v2 + step2);
  next.v3 = within_half_turn(turn.v3 + step3);
  next.v4 = within_half_turn(turn.v4 + step4);
  return next;
}

// The rotations of the segments of a blade of compliance 1/κ under its weight and a virtual load.
ChainVectors virtual_turns(ChainVectors rest, ChainVectors load, float compliance) {
  ChainVectors whole;
  precise vec3 whole1 = load.v1 - vec3(0.0f, 0.0f, 7.0f * compliance);
  precise vec3 whole2 = load.v2 - vec3(0.0f, 0.0f, 5.0f * compliance);
  precise vec3 whole3 = load.v3 - vec3(0.0f, 0.0f, 3.0f * compliance);
  precise vec3 whole4 = load.v4 - vec3(0.0f, 0.0f, compliance);
  whole.v1 = whole1;
  whole.v2 = whole2;
  whole.v3 = whole3;
  whole.v4 = whole4;
  ChainVectors turn;
  turn.v1 = vec3(0.0f, 0.0f, 0.0f);
  turn.v2 = turn.v1;
  turn.v3 = turn.v1;
  turn.v4 = turn.v1;
  // The first step is taken at rest, where a load has no tension yet to stop the blade from shooting past it.
  turn = equilibrium_step(rest, turn, whole, -compliance, 0.5f);
  turn = equilibrium_step(rest, turn, whole, -compliance, 0.0f);
  return equilibrium_step(rest, turn, whole, -compliance, 0.0f);
}

// A texel of the grid holds four vec4: (load, w) of each segment, bottom-up; the w of the first three are the
// displacement of the virtual blade's tip from its place when upright, as a share of its length; that of the
// fourth is free.
ChainVectors texel_load(vec4 texel1, vec4 texel2, vec4 texel3, vec4 texel4) {
  ChainVectors load;
  load.v1 = vec3(texel1.x, texel1.y, texel1.z);
  load.v2 = vec3(texel2.x, texel2.y, texel2.z);
  load.v3 = vec3(texel3.x, texel3.y, texel3.z);
  load.v4 = vec3(texel4.x, texel4.y, texel4.z);
  return load;
}

vec3 texel_tip(vec4 texel1, vec4 texel2, vec4 texel3) {
  return vec3(texel1.w, texel2.w, texel3.w);
}

// What a blade sways by on its own (RG: own frequency and phase, less the more it is bent): a load across its
// breadth at its own lowest frequency, ω = 0.1068 √(κ g/l), in proportion to what the air does to it.
// Deviation: RG moves the vertices. `load`, `tip`: of the texel; `time`: share of kSwayPeriodS that has
// passed, in which every blade sways a whole number of times.
ChainVectors with_own_sway(Blade blade, BladeCurve rest, ChainVectors load, vec3 tip, float time) {
  precise float rate_per_s =
      0.1068f * sqrt(max(blade.stiffness, softest_chain()) * gravity_m_per_s2() * 8.0f / blade.height_m);
  float times = floor(rate_per_s * (kSwayPeriodS * 0.15915494f) + 0.5f);
  precise float passed = times * time;
  precise float angle = 6.2831853f * (passed - floor(passed)) + blade.phase_rad;
  precise float bent = min(tip.x * tip.x + tip.y * tip.y, 1.0f);
  precise float strength =
      0.35f * sqrt(load.v4.x * load.v4.x + load.v4.y * load.v4.y) * (1.0f - bent) * sine(angle);
  precise vec3 across = outer(rest.side, vec3(0.0f, 0.0f, 1.0f)) * strength;
  ChainVectors sum;
  precise vec3 load1 = load.v1 + across * 7.0f;
  precise vec3 load2 = load.v2 + across * 5.0f;
  precise vec3 load3 = load.v3 + across * 3.0f;
  precise vec3 load4 = load.v4 + across;
  sum.v1 = load1;
  sum.v2 = load2;
  sum.v3 = load3;
  sum.v4 = load4;
  return sum;
}

// A blade as chain_of, but moved by a virtual load.
BladeChain virtual_pose(Blade blade, BladeCurve rest, float growth, ChainVectors load) {
  ChainRest relaxed = chain_rest(rest);
  ChainVectors turn = virtual_turns(relaxed.along, load, 1.0f / max(blade.stiffness, softest_chain()));
  return turned_chain(blade, rest, growth, turn);
}

// The same on trodden ground with this normal; `rest` as it grew.
BladeChain pressed_virtual_pose(Blade blade, BladeCurve rest, float growth, ChainVectors load, vec3 normal,
                                Pressing pressing) {
  precise float length_m = blade.height_m * growth;
  BladeCurve pressed = pressed_curve(rest, length_m, normal, pressing);
  ChainRest relaxed = chain_rest(pressed);
  ChainVectors turn = virtual_turns(relaxed.along, load, 1.0f / max(blade.stiffness, softest_chain()));
  return turned_chain_over(blade, pressed, growth, turn, normal, lowest_rise(lying_share(pressing)));
}
