// Sixteen chains as the processor likes them: one row of each number of their state and traits.
#pragma once

#include <cstddef>

#include "shaders/kernels/kernels.h"

namespace prairie {

using ChainVectors = Kernels::ChainVectors;
using ChainMotion = Kernels::ChainMotion;
using ChainTraits = Kernels::ChainTraits;

/// Vectors: x, y, z of the lowest segment, then of the next.
struct alignas(64) ChainBlock {
  static constexpr std::size_t kBlades = 16;
  using Row = float[kBlades];
  Row turn_rad[12];
  Row rate_rad_per_s[12];
  Row rest[12];  // directions of relaxed segments
  Row wind_m_per_s[3];
  Row half_segment_m;
  Row stiffness;
  Row damping_ratio;
  Row drag;
};

inline ChainVectors vectors_in(const ChainBlock::Row* rows, std::size_t n) {
  ChainVectors v;
  v.v1 = {rows[0][n], rows[1][n], rows[2][n]};
  v.v2 = {rows[3][n], rows[4][n], rows[5][n]};
  v.v3 = {rows[6][n], rows[7][n], rows[8][n]};
  v.v4 = {rows[9][n], rows[10][n], rows[11][n]};
  return v;
}

inline void put_vectors(ChainBlock::Row* rows, std::size_t n, const ChainVectors& v) {
  rows[0][n] = v.v1.x;
  rows[1][n] = v.v1.y;
  rows[2][n] = v.v1.z;
  rows[3][n] = v.v2.x;
  rows[4][n] = v.v2.y;
  rows[5][n] = v.v2.z;
  rows[6][n] = v.v3.x;
  rows[7][n] = v.v3.y;
  rows[8][n] = v.v3.z;
  rows[9][n] = v.v4.x;
  rows[10][n] = v.v4.y;
  rows[11][n] = v.v4.z;
}

inline glm::vec3 wind_in(const ChainBlock& block, std::size_t n) {
  return {block.wind_m_per_s[0][n], block.wind_m_per_s[1][n], block.wind_m_per_s[2][n]};
}

inline ChainMotion motion_in(const ChainBlock& block, std::size_t n) {
  ChainMotion motion;
  motion.turn = vectors_in(block.turn_rad, n);
  motion.rate = vectors_in(block.rate_rad_per_s, n);
  return motion;
}

inline ChainTraits traits_in(const ChainBlock& block, std::size_t n) {
  ChainTraits traits;
  traits.half_segment_m = block.half_segment_m[n];
  traits.stiffness = block.stiffness[n];
  traits.damping_ratio = block.damping_ratio[n];
  traits.drag = block.drag[n];
  return traits;
}

}  // namespace prairie
