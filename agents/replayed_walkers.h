// Walkers that go where recorded ones went (agents/track.h) instead of deciding for themselves: each is there
// from its track's first stamp to its last. They see and avoid nobody; their feet step, and tread the grass,
// as those of others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "agents/crowd.h"
#include "agents/gait.h"
#include "agents/track.h"
#include "agents/track_playback.h"
#include "animation/treading.h"
#include "maps/height_field.h"

namespace prairie {

class ReplayedWalkers {
 public:
  /// As they are at `time_s`. Throws BadInput on more than kMostWalkers tracks.
  ReplayedWalkers(std::vector<Track> tracks, const Gait& gait, std::uint64_t seed, double time_s);

  std::span<const Walker> walkers() const { return walkers_; }
  std::span<const WalkerTraits> traits() const { return traits_; }
  bool is_present(std::size_t walker) const { return present_[walker]; }
  const Gait& gait() const { return gait_; }
  /// When the last of them leaves.
  double last_s() const;

  /// Moves everybody on to `to_s`, dt_s later. Returns what the feet do to the grass, ids from `first_id` on.
  std::vector<TreadStep> step(const HeightField& ground, double to_s, double dt_s, std::uint32_t first_id);

  /// Goes on from feet that stand as these walkers' do; throws BadInput, and changes nothing, if they cannot
  /// be these tracks'.
  void restore(std::span<const Walker> walkers, double time_s);

 private:
  std::vector<TrackPlayback> tracks_;
  Gait gait_;
  std::vector<WalkerTraits> traits_;
  std::vector<Walker> walkers_;
  std::vector<bool> present_;
};

}  // namespace prairie
