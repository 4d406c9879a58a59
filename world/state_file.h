// The state of a world as bytes, to be kept in a file and gone on from: what a world does from a state that
// was loaded is, bit for bit, what it would have done.
//
// All numbers are little-endian, counts unsigned. The header:
//
//   bytes  what
//       8  89 50 52 53 0d 0a 1a 0a: "PRS" among bytes that a transfer as text would change
//       4  version of this format, 2
//       8  length of the whole file
//       8  XXH3 (64 bits) of all that follows
//       8  the hash of what moves (motion_hash in world/scene_hash.h)
//
// and then, one after the other:
//
//   time         ticks (int64), of which kTicksPerS make a second
//   settings     those of treading: spacing_m, reach_radii, recovery_s (double); field_scale,
//                most_tilt_rad, load_slowing, worn_slowing, wear_passes, worn_field (float)
//   trodden      count (64 bits) of pages; each: j, i (int32), then 256 nodes: start_s (double), field,
//                recovery_s, blades_recovery_s, direction x, y (float)
//   worn         count (64 bits) of pages; each: j, i (int32), then 256 values (float)
//   eye          0 or 1 (32 bits); for 1: x, y (double)
//   sway         0 or 1 (32 bits); for 1: count (64 bits) of motions; each: turns and rates of its four
//                segments (24 floats)
//   walkers      count (64 bits); each: place x, y, forward x, y, speed (double); its footing: scale,
//                phase, speed (double), of the left and the right foot place x, y, forward x, y (double),
//                planted 0 or 1 (32 bits), share, lift_phase (double); its memory: turn (int32), turned_s
//                (double), goal (int32), goal_since_s, met_m, met_s, moved_s, backs_off_until_s (double)
//   touched      count (64 bits) of cells; each: tile i, j (int32), cell, count (32 bits) of blades; each:
//                index (32 bits), motion (24 floats), rest, offset (12 floats each), rise (float),
//                near_steps, fades (int32)
//
// Pages, cells and blades lie in their order, each once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "agents/crowd.h"
#include "world/motion.h"

namespace prairie {

/// What a state belongs to.
struct StateOwner {
  std::uint64_t motion_hash = 0;
  TreadSettings treading;
};

/// What a file holds.
struct WorldState {
  MotionState motion;
  std::vector<Walker> walkers;
};

/// Of a file.
inline constexpr std::uint64_t kMostStateBytes = std::uint64_t{1} << 30;

/// Throws OverBudget for a state of more than kMostStateBytes.
std::vector<std::byte> state_bytes(const WorldState& state, const StateOwner& owner);

/// Throws BadInput, which names `file`, unless the bytes are a whole, undamaged state of this owner. That its
/// numbers are in their ranges is for Motion and Crowd to tell; they are finite.
WorldState parse_state(std::span<const std::byte> bytes, const StateOwner& owner, const std::string& file);

/// Sets length and checksum of a file that has a header.
void seal_state(std::span<std::byte> bytes);
inline constexpr std::size_t kStateHeaderBytes = 8 + 4 + 8 + 8 + 8;

}  // namespace prairie
