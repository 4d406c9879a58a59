// Inertial blades (B11 §3.1): chains that keep rotation and rate of their segments from step to step, as
// arrays of short blocks that one instruction moves several blades of. The physics is in
// shaders/kernels/chain_motion.glsl; a step here is bit for bit Kernels::chain_after for each blade, whatever
// the processor and the number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "animation/chain_block.h"

namespace prairie {

/// A segment's drag in weights of a segment in wind of 1 m/s, k_w/(m g) of B11 §3.2 with k_w ∝ width:
/// ½ρ c w 2l u₀^(2/3) for the exponent 4/3, which is the force on a stiff strip of drag coefficient `c` at u₀
/// = 1 m/s. Width and length in metres, mass of the whole blade in grams.
float chain_drag(float width_m, float length_m, float mass_g, float drag_coefficient);

class InertialChains {
 public:
  InertialChains() = default;
  explicit InertialChains(std::size_t size);

  std::size_t size() const { return size_; }

  /// Plants a blade anew: relaxed, at rest, in calm air.
  void plant(std::size_t blade, const ChainVectors& rest, const ChainTraits& traits);

  ChainVectors rest(std::size_t blade) const;
  ChainTraits traits(std::size_t blade) const;
  ChainMotion motion(std::size_t blade) const;
  void set_motion(std::size_t blade, const ChainMotion& motion);
  glm::vec3 wind_m_per_s(std::size_t blade) const;
  void set_wind(std::size_t blade, glm::vec3 wind_m_per_s);
  void set_stiffness(std::size_t blade, float stiffness);

  /// Directions of the segments, unit vectors, bottom-up.
  ChainVectors directions(std::size_t blade) const;

  /// All blades; those of the last block beyond size() are upright and never looked at.
  std::span<const ChainBlock> blocks() const { return blocks_; }

  /// Moves all blades on by `dt_s` > 0.
  void step(float dt_s);
  /// The same of the blades of blocks() from `first` to before `end`; different ones may be stepped at the
  /// same time.
  void step_blocks(std::size_t first, std::size_t end, float dt_s);

 private:
  std::size_t size_ = 0;
  std::vector<ChainBlock> blocks_;
};

}  // namespace prairie
