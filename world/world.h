// The assembled prairie: scene, ground and maps in memory, and the state that time moves. No OpenGL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agents/crowd.h"
#include "agents/driven_mover.h"
#include "agents/gait.h"
#include "agents/mover.h"
#include "agents/obstacle.h"
#include "agents/replayed_walkers.h"
#include "agents/track.h"
#include "generator/meadow.h"
#include "maps/height_field.h"
#include "world/map_loading.h"
#include "world/scene/scene.h"

namespace prairie {

class Motion;
class WorkerProcess;

struct WorldOptions {
  std::optional<std::uint64_t> seed;               // overrides the scene's
  std::uint64_t memory_budget_bytes = 2ull << 30;  // for maps
  std::optional<Gait> gait;                        // of walkers, instead of the one that comes along
  WorkerProcess* decoder = nullptr;                // does world/decoder.h's works; none: this process does
};

class World {
 public:
  /// Opens the scene's maps. Maps with a geo-reference lie relative to the height map's (without a height
  /// map, to the first geo-referenced map); others have their south-west node at (0, 0). A scene without a
  /// camera gets one named "default". Throws BadInput, OverBudget.
  World(Scene scene, const WorldOptions& options);

  World(World&&) noexcept;
  ~World();

  const Scene& scene() const { return scene_; }
  /// What is planted: ground, species, density and feature maps, seed, tile grid.
  const Meadow& meadow() const { return meadow_; }
  const std::optional<GeoReference>& geo_reference() const { return geo_reference_; }
  const std::vector<LoadedMap>& maps() const { return maps_; }
  /// Of the scene's settings and its maps' contents; the same wherever the folder lies.
  std::uint64_t scene_hash() const { return scene_hash_; }
  /// Of what grows and moves alone, whatever it is looked at with: to whom a saved state belongs.
  std::uint64_t motion_hash() const { return motion_hash_; }
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// As the scene has them, in its order.
  const std::vector<Mover>& movers() const { return movers_; }

  /// Movers whose places are set from outside; each step takes them from where the last one left them to
  /// where they are.
  const std::vector<DrivenMover>& driven() const { return driven_; }
  std::vector<DrivenMover>& driven() { return driven_; }

  /// What stands in the way of walkers.
  const StandingThings& standing() const { return scene_.standing; }
  /// The scene's walkers; nobody where tracks are replayed.
  const Crowd& crowd() const { return crowd_; }
  Crowd& crowd() { return crowd_; }
  const std::optional<ReplayedWalkers>& replayed() const { return replay_; }
  /// All that walk, whichever they are; those that are not present are not to be seen now.
  std::span<const Walker> walkers() const { return replay_ ? replay_->walkers() : crowd_.walkers(); }
  std::span<const WalkerTraits> walker_traits() const {
    return replay_ ? replay_->traits() : crowd_.traits();
  }
  bool is_present(std::size_t walker) const { return !replay_ || replay_->is_present(walker); }
  const Gait& gait() const { return replay_ ? replay_->gait() : crowd_.gait(); }
  /// Walkers move along these from the scene's beginning on, instead of the scene's own. To be called before
  /// any step. Throws BadInput on more than kMostWalkers tracks.
  void replay(std::vector<Track> tracks);
  /// What each of the crowd perceives now.
  std::vector<Percept> percepts() const;

  /// What time moves. `watch` tells it where the eye is; without one nothing is simulated that only an eye
  /// would see.
  const Motion& motion() const { return *motion_; }
  Motion& motion() { return *motion_; }

  /// An eye above that place looks for the first time (Motion::watch_anew), at blades that its movers have
  /// bent aside.
  void watch_anew(glm::dvec2 eye_m);

  /// Advances the world, its movers included, by a step of more than zero and at most a tenth of a second.
  void step(double dt_s);
  double time_s() const;

  /// What time has moved, as the bytes of a state file (world/state_file.h). Throws OverBudget if those are
  /// too many.
  std::vector<std::byte> saved_state() const;
  /// Goes on from such bytes. Throws BadInput, which names `file`, and changes nothing, if they are not a
  /// state of this scene.
  void load_state(std::span<const std::byte> bytes, const std::string& file);

 private:
  Scene scene_;
  Meadow meadow_;
  std::optional<GeoReference> geo_reference_;
  std::vector<LoadedMap> maps_;
  std::uint64_t scene_hash_ = 0;
  std::uint64_t motion_hash_ = 0;
  std::vector<Warning> warnings_;
  std::vector<Mover> movers_;
  std::vector<DrivenMover> driven_;
  Crowd crowd_{recorded_gait()};
  std::optional<ReplayedWalkers> replay_;
  std::unique_ptr<Motion> motion_;
};

}  // namespace prairie
