// Coordinate systems, as PROJ knows them through GDAL: their units, whether two are one, and places from one
// to another. Coordinates are east before north, longitude before latitude, whatever the system's own order.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace prairie {

/// An immutable coordinate system.
class SpatialReference {
 public:
  /// Nothing where the text (WKT) tells of no system.
  static std::optional<SpatialReference> of_wkt(const std::string& wkt);
  /// "EPSG:4326", WKT or a PROJ string; nothing where it is none of them.
  static std::optional<SpatialReference> of_name(const std::string& name);
  /// Longitude and latitude on WGS 84, degrees.
  static SpatialReference wgs84();
  /// Universal Transverse Mercator on WGS 84 in the zone of a place, with the exceptions for Norway and
  /// Svalbard.
  static SpatialReference utm_at(glm::dvec2 longitude_latitude_deg);

  std::string wkt() const;
  /// "WGS 84 / UTM zone 14N (EPSG:32614)"
  std::string name() const;
  /// Its number in EPSG's registry, where it tells it or is UTM on WGS 84.
  std::optional<int> epsg() const;
  bool is_geographic() const;
  /// Where a place of it is known on Earth.
  bool is_on_earth() const;
  /// Of the plane's unit; of a geographic system 1.
  double metres_per_unit() const;
  /// Of the heights' unit, where it has heights.
  std::optional<double> vertical_metres_per_unit() const;
  /// Whether the places of both are the same numbers; heights aside.
  bool has_plane_of(const SpatialReference& other) const;

  /// OGRSpatialReferenceH, for this room.
  void* handle() const { return handle_.get(); }

 private:
  explicit SpatialReference(void* handle);

  std::optional<int> utm_code() const;

  std::shared_ptr<void> handle_;
};

/// Places from one system into another.
class PlaceTransform {
 public:
  PlaceTransform(const SpatialReference& from, const SpatialReference& to);

  /// In place. False where some place cannot be told in the other system.
  bool apply(std::span<glm::dvec2> places) const;

 private:
  std::shared_ptr<void> handle_;
};

/// Where UTM is used.
inline constexpr double kLeastUtmLatitudeDeg = -80.0, kMostUtmLatitudeDeg = 84.0;

}  // namespace prairie
