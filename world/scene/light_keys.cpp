// [sun], [sky] and [lod].
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

constexpr Bounds kLight{0.0, 100.0};

}  // namespace

const KeyTable<SunSpec>& sun_keys() {
  static const KeyTable<SunSpec> table{{
      key<&SunSpec::azimuth_deg>({.name = "azimuth_deg", .range = kBearingDeg, .hash = {"sun_azimuth_deg"}}),
      key<&SunSpec::elevation_deg>(
          {.name = "elevation_deg", .range = Bounds{0.0, 90.0}, .hash = {"sun_elevation_deg"}}),
      key<&SunSpec::color>({.name = "color", .range = kLight, .hash = {"sun_color"}}),
      key<&SunSpec::intensity>({.name = "intensity", .range = kLight, .hash = {"sun_intensity"}}),
  }};
  return table;
}

const KeyTable<SunSpec>& sky_keys() {
  static const KeyTable<SunSpec> table{{
      key<&SunSpec::sky_intensity>({.name = "intensity", .range = kLight, .hash = {"sky_intensity"}}),
      key<&SunSpec::haze_per_m>({.name = "haze_per_m", .range = kShare, .hash = {"haze_per_m"}}),
  }};
  return table;
}

const KeyTable<LodSpec>& lod_keys() {
  static const KeyTable<LodSpec> table{{
      key<&LodSpec::quality>({.name = "quality", .words = {"low", "medium", "high"}, .hash = {"quality"}}),
      key<&LodSpec::blade_distance_m>(
          {.name = "blade_distance_m", .range = Bounds{1.0, 5000.0}, .hash = {"blade_distance_m"}}),
  }};
  return table;
}

}  // namespace prairie
