// Tracks as lines of bare numbers, parted by blanks, tabs, commas or semicolons, which say by their number
// alone what they are:
//
//   8: obsmat.txt of the UCY and ETH crowds (Lerner et al., Crowds by Example, CGF 26(3), 2007; Pellegrini et
//   al.,
//      You'll Never Walk Alone, ICCV 2009): frame, id, x, z, y and their velocities; metres and metres a
//      second. How many frames there are a second follows from places and velocities, 25 where these say
//      nothing.
//   4: TrajNet (Sadeghian et al. 2018): frame, id, x, y; metres, 25 frames a second; or id, frame, x, y.
//   5: the experiments of the Forschungszentrum Jülich (PeTrack, JuPedSim): id, frame, x, y, z, with comments
//   that tell
//      the frame rate and the unit; without them metres or centimetres by the height z, 16 or 25 frames a
//      second by the speed.
//
// What is guessed is told in TrackRecording::notes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "agents/track_rows.h"

namespace prairie {

inline constexpr double kUsualFramesPerS = 25.0;

/// Whether the first line that is no comment holds numbers alone.
bool is_track_table(std::string_view text);

/// `frames_per_s`: instead of what the file says. Throws BadInput, line and column in it, where the lines are
/// none of these.
TrackRecording read_track_table(std::string_view text, const std::string& name,
                                std::optional<double> frames_per_s);

}  // namespace prairie
