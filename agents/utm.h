// Places on Earth as metres in the plane: Universal Transverse Mercator on WGS 84 (EPSG 32601 to 32660 north,
// 32701 to 32760 south), computed by GeographicLib (Karney, Transverse Mercator with an accuracy of a few
// nanometers, J. Geodesy 85, 2011: the series of sixth order, good to 5 nm here). Distances are those on the
// ground times 0.9996 to 1.001, a zone's own width given.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "maps/georaster/spatial_reference.h"
#include "maps/map_file.h"

namespace prairie {

struct UtmZone {
  int number = 31;  // 1…60
  bool north = true;

  bool operator==(const UtmZone&) const = default;
};

/// Where on Earth the (0, 0) of a scene or of tracks lies.
struct UtmFrame {
  UtmZone zone;
  glm::dvec2 origin_m{0.0};  // easting, northing
};

struct GeoPoint {
  double latitude_deg = 0.0;   // −80…84, where UTM is used
  double longitude_deg = 0.0;  // −180…180
};

/// A zone serves as far from its middle; its own half width is 3.
inline constexpr double kMostDegreesFromMeridian = 9.0;

/// The zone that a map's keys name as EPSG code; none where they name another projection or nothing.
std::optional<UtmZone> utm_zone_of(const GeoReference& reference);

/// Of the map's south-west node, which is a scene's (0, 0).
std::optional<UtmFrame> utm_frame_of(const GeoReference& reference);

/// With the exceptions for Norway and Svalbard.
UtmZone standard_utm_zone(GeoPoint point);

/// −180…180, positive to the east.
double degrees_from_meridian(const UtmZone& zone, GeoPoint point);

/// Easting and northing; the point lies within kMostDegreesFromMeridian of the zone's middle. South of the
/// equator a northern zone's northing is negative.
glm::dvec2 utm_m(const UtmZone& zone, GeoPoint point);

}  // namespace prairie
