// Interaction patches (B11 §2.1, §3.4): the cells that objects touch, whose touched blades keep rotation and
// rate from step to step. Objects bend them aside (animation/contact.h), afterwards they swing inertially,
// and once their motion is spent they fade back into the virtual model and are forgotten
// (animation/handover.h). No other blade is stored.
//
// Deviation: B11 keeps all blades of a patch; here only those that have been touched cost something.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "animation/handover.h"
#include "animation/inertial_chains.h"
#include "animation/solids.h"
#include "animation/standing_blade.h"

namespace prairie {

/// A cell of a tile.
struct CellId {
  TileId tile;
  int cell = 0;
  auto operator<=>(const CellId&) const = default;
};

/// A blade that moves by itself.
struct TouchedBlade {
  std::uint32_t index = 0;  // among the blades of its cell
  ChainMotion motion{};     // from its shape at rest, which treads change
  ChainVectors rest{};      // directions of that
  ChainVectors offset{};    // while it fades: from the virtual blade
  float rise = -1.0f;  // at which its segments rise at least: none has anything to lie on under an object
  std::int32_t near_steps = 0;
  std::int32_t fades = 0;  // 1 while it goes back to the virtual model, 2 once it is there

  bool operator==(const TouchedBlade&) const;
};

/// All that changes; plain data, in the order of cells and indices.
using TouchedState = std::vector<std::pair<CellId, std::vector<TouchedBlade>>>;

/// What blades of one cell and species are drawn from.
struct TouchedGroup {
  glm::uvec2 key;                    // of the PlantedCell
  std::vector<std::uint32_t> slots;  // by blade in the cell's sequence: 0, or 1 + place in chains()
};

class TouchedBlades {
 public:
  /// Moves on by `dt_s`, after which solids lie where they lie. Blades farther than `kReachM` from the eye
  /// are left to the virtual model.
  void step(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m, float dt_s);
  static constexpr double kReachM = 30.0;

  /// Bends blades out of solids that were there before anybody looked.
  void meet(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m);

  std::size_t size() const;
  std::span<const TouchedGroup> groups() const { return groups_; }
  /// Relative to their tile's corner and base, in full length.
  std::span<const Kernels::BladeChain> chains() const { return chains_; }

  TouchedState state() const;
  /// Takes over a state. Throws BadInput, and changes nothing, if it cannot be one of this meadow. Shapes to
  /// draw are there after the next step or `pose`.
  void restore(const TouchedState& state, const Meadow& meadow);
  void pose(const Surroundings& around);

 private:
  struct Patch {
    CellTables tables;
    std::uint32_t blade_count = 0;           // as planted, also before they are
    std::vector<Blade> blades;               // of all species, one after the other
    std::vector<std::uint32_t> first_blade;  // of each of tables.cells
    std::vector<TouchedBlade> touched;       // by index
    std::vector<StandingBlade> standing;     // of each of them, during a step
    bool is_near = false;                    // an object that may touch its blades
  };
  /// Of blades of a patch by their indices.
  static std::vector<StandingBlade> standing(const Surroundings& around, CellId id, const Patch& patch,
                                             std::span<const std::uint32_t> indices);
  static void stand_touched(const Surroundings& around, CellId id, Patch& patch);
  void lay_out(const Meadow& meadow, CellId id, Patch& patch);
  static void plant(const Meadow& meadow, Patch& patch);
  Patch& patch_at(const Meadow& meadow, CellId id);
  void swing(const Surroundings& around, float dt_s);
  void touch(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m);
  void touch_patch(const Surroundings& around, CellId id, Patch& patch,
                   std::span<const Solid* const> objects) const;
  void hand_over(float dt_s);
  void make_chains();

  std::optional<PlantingLattice> lattice_;
  std::map<CellId, Patch> patches_;
  std::vector<TouchedGroup> groups_;
  std::vector<Kernels::BladeChain> chains_;
};

}  // namespace prairie
