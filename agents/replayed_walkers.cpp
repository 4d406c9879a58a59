#include "agents/replayed_walkers.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "agents/foot_treads.h"
#include "agents/skeleton.h"
#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr double kFastestGait_m_per_s = 3.0;  // of what is no walk any more, feet go no faster
constexpr double kHeightSpread = 0.06;

}  // namespace

ReplayedWalkers::ReplayedWalkers(std::vector<Track> tracks, const Gait& gait, std::uint64_t seed,
                                 double time_s)
    : gait_(gait) {
  if (tracks.size() > kMostWalkers)
    throw BadInput("", "tracks", fmt::format("{} tracks", tracks.size()),
                   fmt::format("at most {}", kMostWalkers));
  Kernels kernels;
  for (Track& track : tracks) {
    WalkerTraits traits;
    traits.id = static_cast<std::uint32_t>(track.id);
    const glm::uvec3 words =
        kernels.hash_uvec3(glm::uvec3(static_cast<std::uint32_t>(seed), traits.id, 0x7265706cu));
    traits.height_m *=
        1.0 + kHeightSpread * (2.0 * static_cast<double>(kernels.unit_from_u32(words.x)) - 1.0);
    tracks_.emplace_back(std::move(track));
    const TrackPlace place = tracks_.back().at(time_s);
    Walker walker;
    walker.position_m = place.position_m;
    walker.forward = place.forward;
    walker.footing = standing(place.position_m, place.forward, traits.height_m / kFigureHeightM);
    traits.home_m = place.position_m;
    traits_.push_back(traits);
    walkers_.push_back(walker);
    present_.push_back(place.present);
  }
}

std::vector<TreadStep> ReplayedWalkers::step(const HeightField& ground, double to_s, double dt_s,
                                             std::uint32_t first_id) {
  std::vector<TreadStep> treads;
  for (std::size_t n = 0; n < walkers_.size(); ++n) {
    Walker& walker = walkers_[n];
    const TrackPlace place = tracks_[n].at(to_s);
    const bool was_present = present_[n];
    present_[n] = place.present;
    if (!place.present) continue;
    const Footing before = walker.footing;
    walker.position_m = place.position_m;
    walker.forward = place.forward;
    walker.speed_m_per_s = place.speed_m_per_s;
    if (!was_present) {
      walker.footing = standing(place.position_m, place.forward, before.scale);
      continue;
    }
    const double grade = glm::dot(glm::dvec2(ground.slope(place.position_m)), place.forward);
    advance(walker.footing, gait_,
            {place.position_m, place.forward, std::min(place.speed_m_per_s, kFastestGait_m_per_s), grade},
            dt_s);
    add_foot_treads(before, walker.footing, first_id + static_cast<std::uint32_t>(n) * kTreadIdsPerWalker,
                    treads);
  }
  return treads;
}

double ReplayedWalkers::last_s() const {
  double last_s = 0.0;
  for (const TrackPlayback& track : tracks_) last_s = std::max(last_s, track.last_s());
  return last_s;
}

void ReplayedWalkers::restore(std::span<const Walker> walkers, double time_s) {
  if (walkers.size() != walkers_.size())
    throw BadInput("", "walkers", fmt::format("{} walkers", walkers.size()),
                   fmt::format("{}, as there are tracks", walkers_.size()));
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    check(walkers[n].footing);
    if (walkers[n].footing.scale != walkers_[n].footing.scale)
      throw BadInput("", "walkers", fmt::format("walker {} of another height", n), "the tracks' walkers");
  }
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    const TrackPlace place = tracks_[n].at(time_s);
    walkers_[n] = walkers[n];
    present_[n] = place.present;
  }
}

}  // namespace prairie
