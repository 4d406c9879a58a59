// Rotations as vectors: an axis as long as the angle, up to π.

// (1 − cos φ)/φ² by φ², for φ ≤ π; error 4e-7.
float versine_share(float square) {
  precise float result =
      0.49999967f +
      square * (-0.041664984f + square * (0.0013875137f + square * (-2.4405824e-5f + square * 2.283768e-7f)));
  return result;
}

// (φ − sin φ)/φ³ by φ², for φ ≤ π; error 3e-8.
float sine_gap(float square) {
  precise float result =
      0.16666664f + square * (-0.0083332014f +
                              square * (0.00019830499f + square * (-2.7248007e-6f + square * 2.1378746e-8f)));
  return result;
}

// v turned by a rotation vector of at most π (Rodrigues).
vec3 rotated(vec3 v, vec3 turn, float versine, float gap) {
  precise float sine_share = 1.0f - gap * inner(turn, turn);
  vec3 across = outer(turn, v);
  precise vec3 result = v + across * sine_share + outer(turn, across) * versine;
  return result;
}

vec3 rotated_by(vec3 v, vec3 turn) {
  float square = inner(turn, turn);
  return rotated(v, turn, versine_share(square), sine_gap(square));
}

// A rotation vector no longer than π: further than that no spring is wound.
vec3 within_half_turn(vec3 turn) {
  precise vec3 result = turn * min(1.0f, 3.1415925f / sqrt(inner(turn, turn) + 1.0e-12f));
  return result;
}

// J_l(θ) rate: angular velocity.
vec3 left_jacobian(vec3 turn, vec3 rate, float versine, float gap) {
  vec3 across = outer(turn, rate);
  precise vec3 result = rate + across * versine + outer(turn, across) * gap;
  return result;
}
