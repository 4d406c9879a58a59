// What a recording says of one walker: where it was when. Plain data; how it is played back stands in
// track_playback.h, what files it is read from in track_files.h.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace prairie {

struct Track {
  std::int64_t id = 0;          // as the recording has it; spells of one walker parted by a gap share it
  std::vector<double> times_s;  // at least one, each later than the one before
  std::vector<glm::dvec2> positions_m;  // as many
};

/// The tracks turned about their (0, 0) by `turn_rad`, counter-clockwise, and then moved by `origin_m`: what
/// was recorded at (0, 0) comes to lie at `origin_m`. Distances stay as they are, the direction is right to
/// 4e-7 rad.
std::vector<Track> placed(std::vector<Track> tracks, glm::dvec2 origin_m, double turn_rad);

}  // namespace prairie
