// Symmetric 4 × 4 matrices between the segments of a chain, each entry standing for itself times the 3 × 3
// identity (chain_motion.glsl).

// A symmetric 4 × 4 matrix, then its LDLᵀ decomposition: l in the places of the off-diagonals, 1/d on the
// diagonal.
struct ChainMatrix {
  float m11;
  float m12;
  float m13;
  float m14;
  float m22;
  float m23;
  float m24;
  float m33;
  float m34;
  float m44;
};

// LDLᵀ of a positive definite matrix.
ChainMatrix decomposed(ChainMatrix m) {
  ChainMatrix f;
  precise float d1 = 1.0f / m.m11;
  precise float l21 = m.m12 * d1;
  precise float l31 = m.m13 * d1;
  precise float l41 = m.m14 * d1;
  precise float d2 = 1.0f / (m.m22 - l21 * m.m12);
  precise float e32 = m.m23 - l31 * m.m12;
  precise float e42 = m.m24 - l41 * m.m12;
  precise float l32 = e32 * d2;
  precise float l42 = e42 * d2;
  precise float d3 = 1.0f / (m.m33 - l31 * m.m13 - l32 * e32);
  precise float e43 = m.m34 - l41 * m.m13 - l42 * e32;
  precise float l43 = e43 * d3;
  precise float d4 = 1.0f / (m.m44 - l41 * m.m14 - l42 * e42 - l43 * e43);
  f.m11 = d1;
  f.m12 = l21;
  f.m13 = l31;
  f.m14 = l41;
  f.m22 = d2;
  f.m23 = l32;
  f.m24 = l42;
  f.m33 = d3;
  f.m34 = l43;
  f.m44 = d4;
  return f;
}

// The solution x of LDLᵀ x = right.
ChainVectors solved(ChainMatrix f, ChainVectors right) {
  precise vec3 y1 = right.v1;
  precise vec3 y2 = right.v2 - y1 * f.m12;
  precise vec3 y3 = right.v3 - y1 * f.m13 - y2 * f.m23;
  precise vec3 y4 = right.v4 - y1 * f.m14 - y2 * f.m24 - y3 * f.m34;
  precise vec3 x4 = y4 * f.m44;
  precise vec3 x3 = y3 * f.m33 - x4 * f.m34;
  precise vec3 x2 = y2 * f.m22 - x3 * f.m23 - x4 * f.m24;
  precise vec3 x1 = y1 * f.m11 - x2 * f.m12 - x3 * f.m13 - x4 * f.m14;
  ChainVectors result;
  result.v1 = x1;
  result.v2 = x2;
  result.v3 = x3;
  result.v4 = x4;
  return result;
}
