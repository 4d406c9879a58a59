// From the values that a file stores to the values of a feature: nodata, scale, unit, range, curve and sRGB,
// as maps/map_file.h says.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "maps/map_file.h"
#include "maps/stored_raster.h"

namespace prairie {

/// The least or the largest value of all, and that next to it.
struct Extreme {
  float value = 0.0f;
  double stored = 0.0;
  float next = 0.0f;
  std::uint64_t count = 0;  // of nodes that hold it
};

/// Counts different values until there are many.
class LevelCensus {
 public:
  void take(float value);
  std::size_t count() const { return values_.size(); }
  /// Whether all different values are counted.
  bool is_complete() const { return is_complete_; }

 private:
  std::unordered_set<float> values_;
  float last_ = std::numeric_limits<float>::quiet_NaN();
  bool is_complete_ = true;
};

/// What was seen while mapping, for warnings.
struct ValueCensus {
  std::uint64_t nodes = 0;
  std::uint64_t gaps = 0;
  std::uint64_t out_of_range = 0;  // clamped
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
  double least_quantity = std::numeric_limits<double>::infinity();  // as the file means its values
  double most_quantity = -std::numeric_limits<double>::infinity();
  Extreme lowest, highest;  // of heights
  LevelCensus levels;       // of heights
};

class ValueMapping {
 public:
  /// Throws BadInput where the spec's numbers or the channel's type do not allow a mapping.
  ValueMapping(const MapSpec& spec, MapMeaning meaning, const StoredChannel& channel);

  /// The feature's value of a stored one; NaN = no data.
  float operator()(double stored) const;

  /// Maps pixels of `stored_channels` values, the first `value_channels` of each, to pixels of as many
  /// values (one stored value may become several equal ones). A pixel has data only if all its values have.
  void map_pixels(std::span<const double> stored, int stored_channels, int value_channels,
                  std::span<float> values, ValueCensus* census) const;

  /// Where the file's own scale and offset are set aside for the scene's range: one line; else empty.
  const std::string& note() const { return note_; }

 private:
  bool is_nodata(double stored) const;
  void take_height(const MapSpec& spec);
  void take_share(const MapSpec& spec);
  double quantity(double stored) const { return offset_ + scale_ * (stored / divisor_); }

  MapMeaning meaning_;
  SampleType type_;
  std::vector<double> nodata_;  // as stored values
  double scale_ = 1.0;          // heights: metres of a stored value; shares: its quantity
  double offset_ = 0.0;
  double divisor_ = 1.0;
  double low_ = 0.0;
  double high_ = 1.0;
  double curve_ = 1.0;
  double max_ = 1.0;
  std::string note_;
};

/// The heights that a map may hold, metres: far beyond any planet's, near enough to expose a forgotten nodata
/// value.
inline constexpr float kMaxHeight_m = 1e5f;

}  // namespace prairie
