#include "agents/track_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "agents/gpx_file.h"
#include "agents/track_tables.h"
#include "files/csv_table.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kFarthestTimeS = 1e10, kFarthestM = 1e8, kLargestId = 9007199254740992.0;
constexpr double kLeastStepS = 1e-6;
constexpr double kAfterGpxTimesS = 1e12;  // the year 9999 ends at 2.5e11
constexpr double kGridPerM = 1024.0;
constexpr std::size_t kShown = 40;
constexpr const char* kOtherLayouts =
    "lines of eight (UCY obsmat), four (TrajNet) or five (Jülich) numbers, or GPX";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

TrackRecording read_csv(std::string_view text, const std::string& name) {
  CsvTable table(text, name);
  const std::string expected = fmt::format("CSV with columns time_s, id, x_m, y_m; or {}", kOtherLayouts);
  const std::size_t time = table.need("time_s", expected), id = table.need("id", expected);
  const std::size_t x = table.need("x_m", expected), y = table.need("y_m", expected);
  TrackRecording recording;
  std::size_t line = 1;
  while (table.next_row()) {
    check_row_count(recording.rows.size() + 1, kMostTrackRows, name);
    const double number = table.number(id, -kLargestId, kLargestId);
    if (number != std::trunc(number)) table.refuse(id, "a whole number");
    recording.rows.push_back(
        {static_cast<std::int64_t>(number),
         ++line,
         table.number(time, -kFarthestTimeS, kFarthestTimeS),
         {table.number(x, -kFarthestM, kFarthestM), table.number(y, -kFarthestM, kFarthestM)}});
  }
  return recording;
}

using GpxSegment = std::vector<GpxPoint>;

/// The points that can be placed in `zone`, as metres from its origin.
glm::dvec2 gpx_position_m(const GpxPoint& point, const UtmZone& zone, const std::string& name) {
  const auto [latitude_deg, longitude_deg] = point.at;
  if (latitude_deg < kLeastUtmLatitudeDeg || latitude_deg > kMostUtmLatitudeDeg) {
    throw BadInput(name, fmt::format("line {}: lat", point.line), fmt::format("{}", latitude_deg),
                   fmt::format("{} to {}, where UTM is used", kLeastUtmLatitudeDeg, kMostUtmLatitudeDeg));
  }
  if (const double degrees = degrees_from_meridian(zone, point.at);
      std::abs(degrees) > kMostDegreesFromMeridian) {
    throw BadInput(name, fmt::format("line {}: lon", point.line),
                   fmt::format("{}, {:.1f} degrees from the middle of UTM zone {}", longitude_deg,
                               std::abs(degrees), zone.number),
                   fmt::format("at most {}", kMostDegreesFromMeridian));
  }
  return utm_m(zone, point.at);
}

UtmFrame frame_of_first(const std::vector<GpxSegment>& segments, const std::string& name) {
  for (const GpxSegment& segment : segments) {
    if (segment.empty()) continue;
    const GpxPoint& first = segment.front();
    // Any zone will do for the latitude, which is all that may be wrong before its own is known.
    const double latitude_deg = std::clamp(first.at.latitude_deg, kLeastUtmLatitudeDeg, kMostUtmLatitudeDeg);
    const UtmZone zone = standard_utm_zone({latitude_deg, first.at.longitude_deg});
    return {zone, gpx_position_m(first, zone, name)};
  }
  throw BadInput(name, "", "no point of a track", "a GPX file with trk, trkseg and trkpt");
}

/// The first time of all segments, or one after all that GPX can name.
double start_of(const std::vector<GpxSegment>& segments) {
  double start_s = kAfterGpxTimesS;
  for (const GpxSegment& segment : segments) {
    for (const GpxPoint& point : segment) start_s = std::min(start_s, point.time_s.value_or(start_s));
  }
  return start_s;
}

/// Adds a segment that has no times: at an even pace along it, points that lie where the one before does left
/// out.
void add_untimed(std::vector<TrackRow>& rows, std::vector<TrackRow> segment) {
  double way_m = 0.0;
  for (std::size_t n = 0; n < segment.size(); ++n) {
    const double step_m = n == 0 ? 0.0 : glm::distance(segment[n].position_m, segment[n - 1].position_m);
    if (n > 0 && step_m == 0.0) continue;
    way_m += step_m;
    segment[n].time_s = way_m / kGpxSpeedMPerS;
    segment[n].goes_on = n > 0;
    rows.push_back(segment[n]);
  }
}

TrackRecording read_gpx(std::string_view text, const std::string& name,
                        const std::optional<UtmFrame>& scene) {
  const std::vector<GpxSegment> segments = parse_gpx(text, name);
  const UtmFrame frame = scene ? *scene : frame_of_first(segments, name);
  const double start_s = start_of(segments);
  TrackRecording recording;
  recording.longest_gap_s = kLongestGpxGapS;
  recording.leaves_out_repeated = true;
  recording.is_on_earth = true;
  recording.if_too_fast = "";
  for (std::size_t n = 0; n < segments.size(); ++n) {
    std::vector<TrackRow> rows;
    for (const GpxPoint& point : segments[n]) {
      const bool timed = segments[n].front().time_s.has_value();
      if (point.time_s.has_value() != timed) {
        throw BadInput(name, fmt::format("line {}", point.line),
                       timed ? "a point without a time" : "a point with a time",
                       "a time for all points of a trkseg or for none");
      }
      const glm::dvec2 from_origin_m = gpx_position_m(point, frame.zone, name) - frame.origin_m;
      rows.push_back({static_cast<std::int64_t>(n), point.line, point.time_s.value_or(start_s) - start_s,
                      glm::round(from_origin_m * kGridPerM) / kGridPerM});
    }
    if (rows.empty()) continue;
    if (segments[n].front().time_s) {
      recording.rows.insert(recording.rows.end(), rows.begin(), rows.end());
    } else {
      add_untimed(recording.rows, std::move(rows));
    }
  }
  return recording;
}

/// By rising id; splits where nothing is known for too long.
std::vector<Track> tracks_of(TrackRecording& recording, const std::string& name) {
  std::vector<TrackRow>& rows = recording.rows;
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TrackRow& a, const TrackRow& b) { return a.id < b.id; });
  std::vector<Track> tracks;
  std::size_t left_out = 0;
  const TrackRow* before = nullptr;  // that was kept
  for (const TrackRow& row : rows) {
    const bool again = before != nullptr && before->id == row.id;
    const double step_s = again ? row.time_s - before->time_s : 0.0;
    if (again && !(step_s >= kLeastStepS)) {
      if (recording.leaves_out_repeated) {
        ++left_out;
        continue;
      }
      throw BadInput(name, fmt::format("line {}: time", row.line),
                     fmt::format("{} s after {} s (line {}) for id {}", row.time_s, before->time_s,
                                 before->line, row.id),
                     "times that rise for each walker");
    }
    if (!again || (step_s > recording.longest_gap_s && !row.goes_on)) tracks.push_back({row.id, {}, {}});
    tracks.back().times_s.push_back(row.time_s);
    tracks.back().positions_m.push_back(row.position_m);
    before = &row;
  }
  if (left_out > 0)
    recording.notes.push_back(
        fmt::format("{} points left out whose times repeat or go back, of {}", left_out, rows.size()));
  return tracks;
}

/// Refuses what says one walker's places at times that are always too far apart.
void check_gaps(const std::vector<TrackRow>& rows, const std::vector<Track>& tracks, double longest_gap_s,
                const std::string& name) {
  if (tracks.size() < rows.size()) return;
  double shortest_s = 0.0;
  for (std::size_t n = 1; n < rows.size(); ++n) {
    const double step_s = rows[n].time_s - rows[n - 1].time_s;
    if (rows[n].id == rows[n - 1].id && (shortest_s == 0.0 || step_s < shortest_s)) shortest_s = step_s;
  }
  if (shortest_s == 0.0) return;
  throw BadInput(name, "time", fmt::format("{} s or more between all the places of each walker", shortest_s),
                 fmt::format("at most {} s somewhere", longest_gap_s));
}

void check_speed(const std::vector<Track>& tracks, const TrackRecording& recording, const std::string& name) {
  std::vector<double> speeds_m_per_s;
  for (const Track& track : tracks) {
    for (std::size_t n = 1; n < track.times_s.size(); ++n) {
      const double step_m = glm::distance(track.positions_m[n], track.positions_m[n - 1]);
      if (step_m > 0.0) speeds_m_per_s.push_back(step_m / (track.times_s[n] - track.times_s[n - 1]));
    }
  }
  if (speeds_m_per_s.empty()) return;
  const auto middle = speeds_m_per_s.begin() + static_cast<std::ptrdiff_t>(speeds_m_per_s.size() / 2);
  std::nth_element(speeds_m_per_s.begin(), middle, speeds_m_per_s.end());
  if (*middle <= kMostMedianSpeedMPerS) return;
  throw BadInput(name, "", fmt::format("a median speed of {:.1f} m/s", *middle),
                 fmt::format("walkers at up to {} m/s{}", kMostMedianSpeedMPerS, recording.if_too_fast));
}

/// As spreadsheets write where the comma is the decimal sign: "0,4;1;2,5", or with tabs.
std::string with_commas(std::string text, char between) {
  std::ranges::replace(text, ',', '.');
  std::ranges::replace(text, between, ',');
  return text;
}

TrackRecording read_rows(std::string_view text, const std::string& name, const TrackRequest& request) {
  std::string_view rest = text;
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  const std::size_t first = rest.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && rest[first] == '<') return read_gpx(text, name, request.scene);
  if (is_track_table(rest)) return read_track_table(rest, name, request.frames_per_s);
  const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
  for (const char between : {';', '\t'}) {
    if (line.find(between) != std::string_view::npos)
      return read_csv(with_commas(std::string(rest), between), name);
  }
  if (line.find(',') != std::string_view::npos) return read_csv(text, name);
  throw BadInput(name, "line 1", line.empty() ? "nothing" : fmt::format("\"{}\"", line.substr(0, kShown)),
                 fmt::format("tracks: CSV with columns time_s, id, x_m, y_m; or {}", kOtherLayouts));
}

}  // namespace

TrackFile parse_tracks(std::string_view text, const std::string& name, const TrackRequest& request) {
  TrackRecording recording = read_rows(text, name, request);
  if (recording.rows.empty()) throw BadInput(name, "", "no row", "at least one place of a walker");
  TrackFile file;
  file.tracks = tracks_of(recording, name);
  check_gaps(recording.rows, file.tracks, recording.longest_gap_s, name);
  check_speed(file.tracks, recording, name);
  file.notes = std::move(recording.notes);
  file.is_on_earth = recording.is_on_earth;
  return file;
}

TrackFile read_tracks(const std::filesystem::path& path, const std::string& field,
                      const TrackRequest& request) {
  return parse_tracks(read_text_input(path, field, kMostTrackFileBytes), path.string(), request);
}

}  // namespace prairie
