#include "animation/inertial_chains.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>

// AVX2 is used where the processor has it. Fused multiply-add, which would round differently, stays off
// (-ffp-contract=off).
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PRAIRIE_STAGE __attribute__((noinline, flatten, target_clones("arch=x86-64-v3", "default")))
#else
#define PRAIRIE_STAGE
#endif

namespace prairie {
namespace {

constexpr std::size_t kBlades = ChainBlock::kBlades;
using Lanes = float[kBlades];

inline ChainVectors load(const Lanes* lanes, std::size_t n) {
  ChainVectors v;
  v.v1 = {lanes[0][n], lanes[1][n], lanes[2][n]};
  v.v2 = {lanes[3][n], lanes[4][n], lanes[5][n]};
  v.v3 = {lanes[6][n], lanes[7][n], lanes[8][n]};
  v.v4 = {lanes[9][n], lanes[10][n], lanes[11][n]};
  return v;
}

inline void store(Lanes* lanes, std::size_t n, const ChainVectors& v) {
  lanes[0][n] = v.v1.x;
  lanes[1][n] = v.v1.y;
  lanes[2][n] = v.v1.z;
  lanes[3][n] = v.v2.x;
  lanes[4][n] = v.v2.y;
  lanes[5][n] = v.v2.z;
  lanes[6][n] = v.v3.x;
  lanes[7][n] = v.v3.y;
  lanes[8][n] = v.v3.z;
  lanes[9][n] = v.v4.x;
  lanes[10][n] = v.v4.y;
  lanes[11][n] = v.v4.z;
}

PRAIRIE_STAGE void step_block(ChainBlock& block, float dt_s) {
  for (std::size_t n = 0; n < kBlades; ++n) {
    ChainMotion now;
    now.turn = load(block.turn_rad, n);
    now.rate = load(block.rate_rad_per_s, n);
    ChainTraits traits;
    traits.half_segment_m = block.half_segment_m[n];
    traits.stiffness = block.stiffness[n];
    traits.damping_ratio = block.damping_ratio[n];
    traits.drag = block.drag[n];
    const glm::vec3 wind(block.wind_m_per_s[0][n], block.wind_m_per_s[1][n], block.wind_m_per_s[2][n]);
    const ChainMotion next = Kernels{}.chain_after(now, load(block.rest, n), traits, wind, dt_s);
    store(block.turn_rad, n, next.turn);
    store(block.rate_rad_per_s, n, next.rate);
  }
}

}  // namespace

float chain_drag(float width_m, float length_m, float mass_g, float drag_coefficient) {
  constexpr float kAirKgPerM3 = 1.2f;
  const float weight_n = 1e-3f * mass_g * Kernels{}.gravity_m_per_s2();
  return 0.5f * kAirKgPerM3 * drag_coefficient * width_m * length_m / weight_n;
}

InertialChains::InertialChains(std::size_t size)
    : size_(size), blocks_((size + kBlades - 1) / kBlades, ChainBlock{}) {
  const glm::vec3 up(0.0f, 0.0f, 1.0f);
  const ChainVectors upright{up, up, up, up};
  const ChainTraits traits{0.04f, 60.0f, 0.2f, 0.0f};
  for (std::size_t blade = 0; blade < blocks_.size() * kBlades; ++blade) {
    ChainBlock& block = blocks_[blade / kBlades];
    const std::size_t n = blade % kBlades;
    store(block.rest, n, upright);
    block.half_segment_m[n] = traits.half_segment_m;
    block.stiffness[n] = traits.stiffness;
    block.damping_ratio[n] = traits.damping_ratio;
    block.drag[n] = traits.drag;
  }
}

void InertialChains::plant(std::size_t blade, const ChainVectors& rest, const ChainTraits& traits) {
  assert(blade < size_);
  assert(traits.half_segment_m > 0.0f && traits.damping_ratio >= 0.0f && traits.drag >= 0.0f);
  ChainBlock& block = blocks_[blade / kBlades];
  const std::size_t n = blade % kBlades;
  store(block.rest, n, rest);
  block.half_segment_m[n] = traits.half_segment_m;
  block.stiffness[n] = traits.stiffness;
  block.damping_ratio[n] = traits.damping_ratio;
  block.drag[n] = traits.drag;
  set_motion(blade, ChainMotion{});
  set_wind(blade, glm::vec3(0.0f));
}

ChainVectors InertialChains::rest(std::size_t blade) const {
  assert(blade < size_);
  return load(blocks_[blade / kBlades].rest, blade % kBlades);
}

ChainTraits InertialChains::traits(std::size_t blade) const {
  assert(blade < size_);
  const ChainBlock& block = blocks_[blade / kBlades];
  const std::size_t n = blade % kBlades;
  return {block.half_segment_m[n], block.stiffness[n], block.damping_ratio[n], block.drag[n]};
}

ChainMotion InertialChains::motion(std::size_t blade) const {
  assert(blade < size_);
  const ChainBlock& block = blocks_[blade / kBlades];
  return {load(block.turn_rad, blade % kBlades), load(block.rate_rad_per_s, blade % kBlades)};
}

void InertialChains::set_motion(std::size_t blade, const ChainMotion& motion) {
  assert(blade < size_);
  ChainBlock& block = blocks_[blade / kBlades];
  store(block.turn_rad, blade % kBlades, motion.turn);
  store(block.rate_rad_per_s, blade % kBlades, motion.rate);
}

glm::vec3 InertialChains::wind_m_per_s(std::size_t blade) const {
  assert(blade < size_);
  const auto& wind = blocks_[blade / kBlades].wind_m_per_s;
  return {wind[0][blade % kBlades], wind[1][blade % kBlades], wind[2][blade % kBlades]};
}

void InertialChains::set_wind(std::size_t blade, glm::vec3 wind_m_per_s) {
  assert(blade < size_);
  auto& wind = blocks_[blade / kBlades].wind_m_per_s;
  wind[0][blade % kBlades] = wind_m_per_s.x;
  wind[1][blade % kBlades] = wind_m_per_s.y;
  wind[2][blade % kBlades] = wind_m_per_s.z;
}

ChainVectors InertialChains::directions(std::size_t blade) const {
  return Kernels{}.chain_directions(rest(blade), motion(blade).turn);
}

void InertialChains::step(float dt_s) {
  assert(dt_s > 0.0f);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks_.size(), 16), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) step_block(blocks_[n], dt_s);
  });
}

}  // namespace prairie
