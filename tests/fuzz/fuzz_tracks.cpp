// Recorded tracks of walkers, whatever their format: they are refused with BadInput of one line, or are
// tracks, which can be played back, to finite places and unit vectors.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string_view>

#include "agents/track_files.h"
#include "agents/track_playback.h"
#include "files/error.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void play(const prairie::TrackPlayback& playback) {
  for (const double share : {-0.1, 0.0, 0.01, 0.3, 0.5, 0.77, 1.0, 1.1}) {
    const double time_s = playback.first_s() + share * (playback.last_s() - playback.first_s());
    const prairie::TrackPlace place = playback.at(time_s);
    require(std::isfinite(place.position_m.x) && std::isfinite(place.position_m.y));
    require(std::isfinite(place.speed_m_per_s));
    require(std::abs(glm::length(place.forward) - 1.0) < 1e-9);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prairie;
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::vector<Track> tracks = parse_tracks(text, "tracks").tracks;
    require(!tracks.empty());
    for (const Track& track : tracks) {
      require(!track.times_s.empty() && track.times_s.size() == track.positions_m.size());
      for (std::size_t n = 1; n < track.times_s.size(); ++n) require(track.times_s[n] > track.times_s[n - 1]);
      play(TrackPlayback(track));
    }
  } catch (const BadInput& fault) {
    require(fault.file == "tracks");
    require(std::string_view(fault.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
