// GPX 1.0 and 1.1 (topografix.com/GPX/1/1): the points of its tracks, read by pugixml. Way points, routes,
// heights and extensions are passed over; a document type is not looked at, and no entities but XML's own
// five are replaced.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/utm.h"

namespace prairie {

/// A tree takes up to some 25 times as many bytes as its text.
inline constexpr std::size_t kMostGpxBytes = std::size_t{32} << 20;

struct GpxPoint {
  GeoPoint at;                   // within the whole of Earth
  std::optional<double> time_s;  // since 1970, UTC, leap seconds not counted
  std::size_t line = 1;          // of the file
};

/// The segments (`trkseg`) of all tracks in the file's order, empty ones included. Throws BadInput, the line
/// in it, where the text is longer than kMostGpxBytes, no XML, no GPX, or holds what is no place or no time.
std::vector<std::vector<GpxPoint>> parse_gpx(std::string_view text, const std::string& name);

/// Seconds since 1970 of an ISO 8601 time as GPX has it: "2010-08-05T14:23:59.5+02:00"; "Z" or nothing is
/// UTC. Nothing where it is none.
std::optional<double> parse_gpx_time(std::string_view text);

}  // namespace prairie
