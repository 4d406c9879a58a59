// Recorded tracks of walkers, read from a person's file. Which format it has is told by its contents:
//
//   CSV: a line of column names with `time_s`, `id`, `x_m`, `y_m` among them, in any order; what else there
//   is is passed over (as in what `--trajectories` writes). Rows of different walkers may come in any order,
//   those of one by time. Semicolons or tabs may stand for the commas, decimal commas for points.
//
//   lines of bare numbers (track_tables.h): UCY and ETH obsmat, TrajNet, Jülich.
//
//   GPX (gpx_file.h): each `trkseg` is a track, whose id is its number from 0, empty ones counted and passed
//   over. Time 0 is the first time in the file. A segment without times is walked at kGpxSpeedMPerS from time
//   0, without gaps.
//
// A walker of whom nothing is known for longer than kLongestGapS (GPX: kLongestGpxGapS, since loggers put
// points 8 to 11 s apart at medium and up to minutes where somebody rests) leaves and comes back: its track
// is split there into several of the same id. A piece of one point is kept: the walker is seen for that
// instant.
//
// Positions of CSV and UCY are taken as they are (`placed` moves them). Those of GPX become metres east and
// north of a scene's (0, 0), where the caller knows where on Earth it lies, or else of the file's first
// point, in the UTM zone of either. They are rounded to 1/1024 m, so that they do not depend on the machine's
// sines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/track.h"
#include "agents/utm.h"

namespace prairie {

inline constexpr double kLongestGapS = 5.0;
inline constexpr double kLongestGpxGapS = 120.0;
inline constexpr double kGpxSpeedMPerS = 1.2;

/// The median speed over all steps of a file that lead anywhere may not be above it: then positions are
/// hardly in metres.
inline constexpr double kMostMedianSpeedMPerS = 12.0;

inline constexpr std::size_t kMostTrackFileBytes = std::size_t{256} << 20;  // GPX: kMostGpxBytes
inline constexpr std::size_t kMostTrackRows = 4'000'000;                    // points of all walkers

struct TrackRequest {
  std::optional<UtmFrame> scene =
      std::nullopt;  // where on Earth the scene's (0, 0) lies, for places on Earth
  std::optional<double> frames_per_s = std::nullopt;  // of files that count frames, instead of what they say
};

struct TrackFile {
  std::vector<Track> tracks;       // by rising id and time
  std::vector<std::string> notes;  // what was guessed, or left out
  bool is_on_earth = false;        // lies where it was on Earth, or about its first point
};

/// `name`: of the file, for messages. O(n log n). Throws BadInput, line and values in it, on what is none of
/// these layouts, on no row or too many, a cell that is no number or out of range (times ±1e10 s, positions
/// ±1e8 m, ids whole and within ±2^53), a time of a walker less than a microsecond after the one before (of
/// GPX such points are left out), a median speed as above, a file whose walkers are never seen twice within
/// the longest gap, or GPX further than kMostDegreesFromMeridian from the scene's zone or from where UTM is
/// used.
TrackFile parse_tracks(std::string_view text, const std::string& name, const TrackRequest& request = {});

/// Of a file of at most kMostTrackFileBytes; `field` names what asked for it. Throws BadInput as parse_tracks
/// does.
TrackFile read_tracks(const std::filesystem::path& path, const std::string& field,
                      const TrackRequest& request = {});

}  // namespace prairie
