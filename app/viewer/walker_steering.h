// A walker that the person at the window steers, one at a time; all others go on deciding for themselves.
// Knows nothing of windows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "agents/behaviour.h"
#include "agents/crowd.h"

namespace prairie {

class World;

/// What the held arrow keys and shift ask of a walker.
struct WalkerControls {
  double ahead = 0.0;  // above 0 it walks, else it stands
  double left = 0.0;   // the side to which it turns; to the right below 0
  bool fast = false;
};

inline constexpr double kFastWalkMPerS = 2.0;

/// At its canonical speed, or fast; turning away from where it looks until nothing is held.
MotorCommand command_of(const WalkerControls& controls, const Walker& walker, const WalkerTraits& traits);

class WalkerSteering {
 public:
  /// The world must outlive it.
  explicit WalkerSteering(World& world) : world_(world) {}
  ~WalkerSteering() { release(); }
  WalkerSteering(const WalkerSteering&) = delete;
  WalkerSteering& operator=(const WalkerSteering&) = delete;

  std::optional<std::size_t> steered() const { return steered_; }

  /// Takes the walker that is watched, or gives it back. Returns what to tell the person.
  std::string toggle(std::optional<std::size_t> watched);
  /// Gives back whoever is not watched any more.
  void keep_only(std::optional<std::size_t> watched);
  void release();
  /// The steered walker, if there is one, obeys.
  void steer(const WalkerControls& controls);

 private:
  World& world_;
  std::optional<std::size_t> steered_;
};

}  // namespace prairie
