// From the samples of a file to the values of a feature: nodata, range, curve and sRGB, as maps/map_file.h
// says.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "maps/map_file.h"
#include "pictures/raster_file.h"

namespace prairie {

/// What was seen while mapping, for warnings.
struct ValueCensus {
  std::uint64_t nodes = 0;
  std::uint64_t gaps = 0;
  std::uint64_t out_of_range = 0;  // clamped
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
};

class ValueMapping {
 public:
  /// `file_nodata`: the file's own. Throws BadInput where the spec's numbers or the file's type do not allow
  /// a mapping.
  ValueMapping(const MapSpec& spec, MapMeaning meaning, SampleType type, std::optional<double> file_nodata);

  /// The feature's value of a sample (integers as v / largest); NaN = no data.
  float operator()(float sample) const;

  /// Maps pixels of `sample_channels` samples, the first `value_channels` of each, to pixels of as many
  /// values (one sample may become several equal values). A pixel has data only if all its samples have.
  void map_pixels(std::span<const float> samples, int sample_channels, int value_channels,
                  std::span<float> values, ValueCensus* census) const;

 private:
  bool is_nodata(float sample) const;
  double raw(float sample) const;

  MapMeaning meaning_;
  SampleType type_;
  std::vector<double> nodata_;  // as raw values
  double low_ = 0.0;
  double high_ = 1.0;
  double curve_ = 1.0;
  double max_ = 1.0;
};

/// The heights that a map may hold, metres: far beyond any planet's, near enough to expose a forgotten nodata
/// value.
inline constexpr float kMaxHeight_m = 1e5f;

}  // namespace prairie
