// Walkers that see, avoid one another and walk (G03 §5): perception (d, θ), behaviour (d, θ) → (v, φ),
// motion, gait.
//
// Nobody walks through anything: whatever a behaviour wants, a step is cut so that it stays on its side of
// the line midway to each near walker, and in front of the line at right angles to the shortest way to each
// near obstacle. As all shapes are convex, neither lets two of them touch. Only a mover, which yields to
// nobody, pushes walkers out of its way.
//
// Deterministic: a step reads the walkers as they were and writes each anew, whatever the number of threads;
// noise is a function of seed, walker and time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "agents/behaviour.h"
#include "agents/crowd_spec.h"
#include "agents/footprint.h"
#include "agents/gait.h"
#include "agents/obstacle_map.h"
#include "agents/walker.h"
#include "animation/treading.h"
#include "maps/height_field.h"

namespace prairie {

/// Where walkers walk.
struct CrowdSurroundings {
  const HeightField& ground;
  std::span<const Footprint> movers;  // at the end of the step; they yield to nobody
  /// How many times as dear as on bare ground a step through the vegetation there is, ≥ 1; empty: 1
  /// everywhere.
  std::function<double(glm::dvec2)> effort;
};

class Crowd {
 public:
  /// Nobody.
  explicit Crowd(const Gait& gait);
  /// Strews the walkers over free ground. Throws BadInput, the group and field in it, on groups out of range,
  /// places inside of obstacles or of one another, or where there is no room.
  Crowd(std::span<const WalkerGroup> groups, std::vector<Footprint> obstacles, Gait gait, std::uint64_t seed);

  std::span<const Walker> walkers() const { return walkers_; }
  std::span<const WalkerTraits> traits() const { return traits_; }
  const Gait& gait() const { return gait_; }
  const ObstacleMap& obstacles() const { return obstacles_; }

  /// What each walker perceives now; `movers` as they are.
  std::vector<Percept> percepts(std::span<const Footprint> movers) const;

  /// Moves everybody on from `time_s` by 0 < dt_s ≤ 0.1. Returns what the feet do to the grass, ids from
  /// `first_id` on.
  std::vector<TreadStep> step(const CrowdSurroundings& around, double time_s, double dt_s,
                              std::uint32_t first_id);

  /// From now on this walker obeys the command, as far as nothing is in its way; no part of the state.
  void steer(std::size_t walker, const MotorCommand& command);
  /// It decides for itself again.
  void release(std::size_t walker);
  bool is_steered(std::size_t walker) const { return steered_[walker].has_value(); }

  /// Throws BadInput, and changes nothing, unless these can be this crowd's walkers.
  void restore(std::vector<Walker> walkers);

 private:
  struct Group {
    std::vector<Goal> goals;
  };
  class Neighbours;

  Percept perceived(std::size_t index, const Neighbours& neighbours, std::span<const Footprint> movers) const;
  MotorCommand decided(std::size_t index, const Percept& nearest, double time_s, Memory& memory) const;
  Walker moved(std::size_t index, const Neighbours& neighbours, const CrowdSurroundings& around,
               double time_s, double dt_s) const;

  std::vector<Group> groups_;
  std::vector<WalkerTraits> traits_;
  std::vector<Walker> walkers_;
  std::vector<std::optional<MotorCommand>> steered_;
  ObstacleMap obstacles_;
  Gait gait_;
  std::uint32_t seed_ = 0;
};

}  // namespace prairie
