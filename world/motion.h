// What time moves in a world: the wind, the trodden grass, what comes over the grass, and around the eye that
// watches, the swaying of blades (design.md, D4). A step is the same for any number of threads, and any state
// can be taken out, kept and restored.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "agents/mover.h"
#include "animation/condition_window.h"
#include "animation/sway.h"
#include "animation/touched_blades.h"
#include "animation/treading.h"
#include "animation/wind.h"
#include "generator/meadow.h"
#include "world/scene/scene.h"

namespace prairie {

/// Whole numbers of ticks make all usual frame rates, so that times do not depend on how they were reached.
inline constexpr std::int64_t kTicksPerS = 705'600'000;

inline double seconds_of(std::int64_t ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerS);
}

/// All that changes but the camera's wake and winds and conditions that were spawned or set, which belong to
/// a person at a window; plain data.
struct MotionState {
  std::int64_t ticks = 0;
  TreadState treading;
  std::optional<glm::dvec2> eye_m;  // if one watches
  std::optional<SwayState> sway;    // around the eye, if there is wind, too
  TouchedState touched;
};

class Motion {
 public:
  /// Throws BadInput on settings or a wind file that cannot be used.
  Motion(const Scene& scene, const Meadow& meadow);

  std::int64_t ticks() const { return ticks_; }
  double time_s() const { return seconds_of(ticks_); }
  /// Around which blades sway; nothing as long as nobody watches.
  const std::optional<glm::dvec2>& eye_m() const { return eye_m_; }
  const Wind& wind() const { return wind_; }
  const Treading& treading() const { return treading_; }
  /// Nothing in still air, or as long as nobody watches.
  const std::optional<Sway>& sway() const { return sway_; }
  /// Blades near the eye that movers have touched.
  const TouchedBlades& touched() const { return touched_; }
  /// What has come over the grass around the eye; null where nothing ever does, or as long as nobody watches.
  const ConditionWindow* conditions() const {
    return eye_m_ && condition_window_ ? &*condition_window_ : nullptr;
  }
  /// Neither wind nor treads nor conditions: grass looks as it was planted.
  bool is_still() const { return !sway_ && conditions() == nullptr && treading_.bytes() == 0; }

  /// From now on it also blows: grass that stood in calm air begins to sway from rest.
  void spawn(const WindPrimitive& primitive);
  /// From now on it also comes over the grass.
  void spawn(const Condition& condition);
  /// Replaces the steady wind and its turbulence from now on; primitives stay.
  void set_wind(const MeanWind& mean, const std::optional<NoiseWind>& noise);

  /// From now on the eye that watches stirs the air as it moves (animation/camera_wake.h), or no longer. What
  /// it stirs is no part of the state: restoring one ends it.
  void wake(bool stirs);

  /// An eye above that place looks for the first time: blades around it sway as they would have for some
  /// seconds, which makes what it sees a function of place and time alone.
  void watch_anew(glm::dvec2 eye_m);
  /// The eye has moved.
  void watch(glm::dvec2 eye_m);

  /// What stands in the grass has stood there before the eye came.
  void meet(const Meadow& meadow, std::span<const Solid> solids);

  /// Moves everything on by so many ticks while bodies make their steps; afterwards solids lie where they
  /// lie.
  void step(const Meadow& meadow, std::int64_t ticks, std::span<const TreadStep> bodies,
            std::span<const Solid> solids);

  MotionState state() const;
  /// Throws BadInput, and changes nothing, if the state cannot be one of this scene.
  void restore(const Meadow& meadow, MotionState state);

 private:
  bool blows() const;
  void begin_to_sway();
  void stir();
  void show_conditions();
  Surroundings surroundings(const Meadow& meadow) const;

  std::int64_t ticks_ = 0;
  bool has_wind_;
  std::vector<SwaySpecies> species_;
  std::vector<ChainTraits> traits_;  // the same
  Wind wind_;
  Treading treading_;
  std::vector<Condition> conditions_;
  std::size_t scene_primitives_, scene_conditions_;  // the first of them are the scene's
  std::optional<glm::dvec2> eye_m_;
  std::optional<ConditionWindow> condition_window_;  // once there, kept: what shows it goes by its revision
  std::optional<Sway> sway_;
  TouchedBlades touched_;
};

}  // namespace prairie
