#include "animation/inertial_chains.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>

#include "generator/vector_stage.h"

namespace prairie {
namespace {

constexpr std::size_t kBlades = ChainBlock::kBlades;

void put_traits(ChainBlock& block, std::size_t n, const ChainTraits& traits) {
  block.half_segment_m[n] = traits.half_segment_m;
  block.stiffness[n] = traits.stiffness;
  block.damping_ratio[n] = traits.damping_ratio;
  block.drag[n] = traits.drag;
}

PRAIRIE_VECTOR_STAGE void step_block(ChainBlock& block, float dt_s) {
  for (std::size_t n = 0; n < kBlades; ++n) {
    const ChainMotion next = Kernels{}.chain_after(motion_in(block, n), vectors_in(block.rest, n),
                                                   traits_in(block, n), wind_in(block, n), dt_s);
    put_vectors(block.turn_rad, n, next.turn);
    put_vectors(block.rate_rad_per_s, n, next.rate);
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
  for (ChainBlock& block : blocks_) {
    for (std::size_t n = 0; n < kBlades; ++n) {
      put_vectors(block.rest, n, {up, up, up, up});
      put_traits(block, n, {0.04f, 60.0f, 0.2f, 0.0f});
    }
  }
}

void InertialChains::plant(std::size_t blade, const ChainVectors& rest, const ChainTraits& traits) {
  assert(blade < size_);
  assert(traits.half_segment_m > 0.0f && traits.damping_ratio >= 0.0f && traits.drag >= 0.0f);
  put_vectors(blocks_[blade / kBlades].rest, blade % kBlades, rest);
  put_traits(blocks_[blade / kBlades], blade % kBlades, traits);
  set_motion(blade, ChainMotion{});
  set_wind(blade, glm::vec3(0.0f));
}

ChainVectors InertialChains::rest(std::size_t blade) const {
  assert(blade < size_);
  return vectors_in(blocks_[blade / kBlades].rest, blade % kBlades);
}

ChainTraits InertialChains::traits(std::size_t blade) const {
  assert(blade < size_);
  return traits_in(blocks_[blade / kBlades], blade % kBlades);
}

ChainMotion InertialChains::motion(std::size_t blade) const {
  assert(blade < size_);
  return motion_in(blocks_[blade / kBlades], blade % kBlades);
}

void InertialChains::set_motion(std::size_t blade, const ChainMotion& motion) {
  assert(blade < size_);
  put_vectors(blocks_[blade / kBlades].turn_rad, blade % kBlades, motion.turn);
  put_vectors(blocks_[blade / kBlades].rate_rad_per_s, blade % kBlades, motion.rate);
}

glm::vec3 InertialChains::wind_m_per_s(std::size_t blade) const {
  assert(blade < size_);
  return wind_in(blocks_[blade / kBlades], blade % kBlades);
}

void InertialChains::set_wind(std::size_t blade, glm::vec3 wind_m_per_s) {
  assert(blade < size_);
  ChainBlock& block = blocks_[blade / kBlades];
  for (int axis = 0; axis < 3; ++axis) block.wind_m_per_s[axis][blade % kBlades] = wind_m_per_s[axis];
}

void InertialChains::set_stiffness(std::size_t blade, float stiffness) {
  assert(blade < size_ && stiffness > 0.0f);
  blocks_[blade / kBlades].stiffness[blade % kBlades] = stiffness;
}

ChainVectors InertialChains::directions(std::size_t blade) const {
  return Kernels{}.chain_directions(rest(blade), motion(blade).turn);
}

void InertialChains::step(float dt_s) {
  assert(dt_s > 0.0f);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks_.size(), 16),
                    [&](const auto& range) { step_blocks(range.begin(), range.end(), dt_s); });
}

void InertialChains::step_blocks(std::size_t first, std::size_t end, float dt_s) {
  assert(end <= blocks_.size());
  for (std::size_t n = first; n < end; ++n) step_block(blocks_[n], dt_s);
}

}  // namespace prairie
