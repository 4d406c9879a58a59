#include "app/viewer/walker_steering.h"

#include <fmt/format.h>

#include <algorithm>

#include "world/world.h"

namespace prairie {
namespace {

// Cosine and sine of the angle to where a turning walker is told to look, some 53°: wide enough to turn at
// full rate, and it still walks while it turns.
constexpr double kAhead = 0.6, kAside = 0.8;

}  // namespace

MotorCommand command_of(const WalkerControls& controls, const Walker& walker, const WalkerTraits& traits) {
  MotorCommand command;
  command.heading = walker.forward;
  if (controls.left != 0.0) {
    const glm::dvec2 left(-walker.forward.y, walker.forward.x);
    command.heading = kAhead * walker.forward + (controls.left > 0.0 ? kAside : -kAside) * left;
  }
  if (controls.ahead > 0.0)
    command.speed_m_per_s =
        controls.fast ? std::max(kFastWalkMPerS, traits.speed_m_per_s) : traits.speed_m_per_s;
  return command;
}

std::string WalkerSteering::toggle(std::optional<std::size_t> watched) {
  if (steered_) {
    release();
    return "the walker decides for itself again";
  }
  if (!watched) return "K watches a walker; then U takes it";
  if (world_.replayed()) return "walkers of recorded tracks cannot be steered";
  steered_ = watched;
  steer({});
  return fmt::format("arrows steer walker {}; U gives it back", *steered_);
}

void WalkerSteering::keep_only(std::optional<std::size_t> watched) {
  if (steered_ != watched) release();
}

void WalkerSteering::release() {
  if (steered_) world_.crowd().release(*steered_);
  steered_.reset();
}

void WalkerSteering::steer(const WalkerControls& controls) {
  if (!steered_) return;
  const Crowd& crowd = world_.crowd();
  world_.crowd().steer(*steered_,
                       command_of(controls, crowd.walkers()[*steered_], crowd.traits()[*steered_]));
}

}  // namespace prairie
