#include "maps/value_mapping.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/error.h"
#include "pictures/srgb.h"

namespace prairie {
namespace {

constexpr double kCustomaryNodata = -9999.0;
// Of surveys: SRTM and its kin; no ground on Earth lies as low.
constexpr std::array kCustomaryHeightNodata{-32768.0, -32767.0, -99999.0};
constexpr double kHugeNodata = 3.4e38f;  // as files of floats hold it
constexpr double kMaxDensity = 1e5;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A nodata value as a file of the given type can hold it.
double stored_as(double nodata, SampleType type) {
  if (type.is_integer() || type.bits == 64) return nodata;
  const float value = static_cast<float>(nodata);
  if (type.bits != 16) return static_cast<double>(value);
  std::uint16_t half = 0;
  float rounded = 0.0f;
  OIIO::convert_types(OIIO::TypeDesc::FLOAT, &value, OIIO::TypeDesc::HALF, &half, 1);
  OIIO::convert_types(OIIO::TypeDesc::HALF, &half, OIIO::TypeDesc::FLOAT, &rounded, 1);
  return static_cast<double>(rounded);
}

/// 0…1 of an integer, as OpenImageIO makes it.
float colour_share(double stored, SampleType type) {
  return static_cast<float>(stored) * (1.0f / static_cast<float>(type.largest));
}

[[noreturn]] void fail(const MapSpec& spec, const std::string& found, const std::string& expected) {
  throw BadInput(spec.file.string(), spec.field, found, expected);
}

void check_range(const MapSpec& spec) {
  if (!spec.range) return;
  const auto [low, high] = *spec.range;
  if (!std::isfinite(low) || !std::isfinite(high) || low == high)
    fail(spec, fmt::format("`range` of {}, {}", low, high), "two different finite numbers");
}

/// Needs to be told before the census' own extremes.
void take_extremes(float value, double stored, ValueCensus& census) {
  census.levels.take(value);
  const auto take = [&](Extreme& extreme, bool is_beyond, bool is_nearer) {
    if (extreme.count == 0 || is_beyond) {
      const float next = extreme.count == 0 ? value : extreme.value;
      extreme = {.value = value, .stored = stored, .next = next, .count = 1};
    } else if (value == extreme.value) {
      ++extreme.count;
    } else if (is_nearer || extreme.next == extreme.value) {
      extreme.next = value;
    }
  };
  take(census.lowest, value < census.lowest.value, value < census.lowest.next);
  take(census.highest, value > census.highest.value, value > census.highest.next);
}

}  // namespace

void LevelCensus::take(float value) {
  constexpr std::size_t kMany = 4096;
  if (!is_complete_ || value == last_) return;
  last_ = value;
  values_.insert(value);
  is_complete_ = values_.size() <= kMany;
}

ValueMapping::ValueMapping(const MapSpec& spec, MapMeaning meaning, const StoredChannel& channel)
    : meaning_(meaning), type_(channel.type), scale_(channel.scale), offset_(channel.offset) {
  nodata_.push_back(stored_as(kCustomaryNodata, type_));
  if (meaning == MapMeaning::kHeight) {
    for (const double nodata : kCustomaryHeightNodata) nodata_.push_back(stored_as(nodata, type_));
  }
  const std::optional<double> nodata = spec.nodata ? spec.nodata : channel.nodata;
  if (nodata && std::isfinite(*nodata)) nodata_.push_back(stored_as(*nodata, type_));
  check_range(spec);
  if (spec.scale && (meaning != MapMeaning::kHeight || !(*spec.scale > 0.0) || !std::isfinite(*spec.scale)))
    fail(spec, fmt::format("`scale` of {}", *spec.scale), "metres per unit of the heights, above 0");
  if (spec.scale && spec.range) fail(spec, "both `scale` and `range`", "one of them");
  if (meaning == MapMeaning::kHeight) {
    take_height(spec);
    const bool is_told = spec.range || spec.scale || channel.is_measured || !type_.is_integer();
    if (!is_told) {
      fail(spec, fmt::format("heights as {}-bit integers", type_.bits),
           fmt::format("`range`, the heights in metres of the values 0 and {:.0f}", type_.largest));
    }
    scale_ *= channel.metres_per_unit;
    offset_ *= channel.metres_per_unit;
  } else if (meaning != MapMeaning::kColor) {
    take_share(spec);
  }
}

void ValueMapping::take_height(const MapSpec& spec) {
  if (spec.scale) {
    scale_ *= *spec.scale;
    offset_ *= *spec.scale;
    return;
  }
  if (!spec.range) return;
  const auto [low, high] = *spec.range;
  if (std::max(std::abs(low), std::abs(high)) > static_cast<double>(kMaxHeight_m))
    fail(spec, fmt::format("`range` of {}, {} m", low, high),
         fmt::format("heights within ±{:.0f} m", kMaxHeight_m));
  const double largest = type_.is_integer() ? type_.largest : 1.0;
  const bool has_own_scale = scale_ != 1.0 || offset_ != 0.0;
  // A range of the stored values themselves says nothing that the file does not say better.
  if (has_own_scale && low == 0.0 && high == largest) return;
  if (has_own_scale) {
    note_ = fmt::format("`range` is used instead of the file's own scale {} and offset {}", scale_, offset_);
  }
  scale_ = high - low;
  divisor_ = largest;
  offset_ = low;
}

void ValueMapping::take_share(const MapSpec& spec) {
  const auto [least, most] = std::minmax({quantity(type_.is_integer() ? -type_.largest : 0.0),
                                          quantity(type_.is_integer() ? type_.largest : 1.0)});
  if (spec.range) {
    low_ = (*spec.range)[0];
    high_ = (*spec.range)[1];
    const bool has_own_scale = scale_ != 1.0 || offset_ != 0.0;
    if (has_own_scale && type_.is_integer() &&
        (std::max(low_, high_) > most || std::min(low_, high_) < least)) {
      note_ = fmt::format(
          "`range` lies beyond the values that the file's own scale {} and offset {} allow: it is taken for "
          "one "
          "of the stored integers",
          scale_, offset_);
      scale_ = 1.0;
      offset_ = 0.0;
    }
  } else if (type_.is_integer()) {
    low_ = quantity(0.0);
    high_ = quantity(type_.largest);
  }
  if (!(spec.max >= 0.0 && spec.max <= kMaxDensity))
    fail(spec, fmt::format("`max` of {}", spec.max), fmt::format("a number from 0 to {:.0f}", kMaxDensity));
  max_ = spec.max;
  if (meaning_ == MapMeaning::kFactor) return;
  if (!(spec.curve > 0.0) || !std::isfinite(spec.curve))
    fail(spec, fmt::format("`curve` of {}", spec.curve), "a finite number above 0");
  curve_ = spec.curve;
}

bool ValueMapping::is_nodata(double stored) const {
  if (!(std::abs(stored) < kHugeNodata)) return true;  // NaN and infinities too
  return std::ranges::find(nodata_, stored) != nodata_.end();
}

float ValueMapping::operator()(double stored) const {
  if (is_nodata(stored)) return kNaN;
  switch (meaning_) {
    case MapMeaning::kHeight:
      return static_cast<float>(quantity(stored));
    case MapMeaning::kDensity:
    case MapMeaning::kFactor: {
      const double share = std::clamp((quantity(stored) - low_) / (high_ - low_), 0.0, 1.0);
      return static_cast<float>(max_ * (curve_ == 1.0 ? share : std::pow(share, curve_)));
    }
    case MapMeaning::kColor:
      if (!type_.is_integer()) return static_cast<float>(quantity(stored));
      if (type_.bits > 16) return static_cast<float>(stored / type_.largest);
      return linear_from_srgb(std::max(colour_share(stored, type_), 0.0f));
  }
  return kNaN;
}

void ValueMapping::map_pixels(std::span<const double> stored, int stored_channels, int value_channels,
                              std::span<float> values, ValueCensus* census) const {
  const std::size_t stride = static_cast<std::size_t>(stored_channels);
  const std::size_t channels = static_cast<std::size_t>(value_channels);
  const std::size_t used = std::min(stride, channels);
  const std::size_t pixels = stored.size() / stride;
  const bool clamps = meaning_ == MapMeaning::kDensity || meaning_ == MapMeaning::kFactor;
  // A limit that someone wrote in decimals must not exclude the float nearest to it.
  const double slack = 1e-6 * std::abs(high_ - low_);
  const double low = std::min(low_, high_) - slack;
  const double high = std::max(low_, high_) + slack;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const double* in = stored.data() + pixel * stride;
    float* out = values.data() + pixel * channels;
    bool has_data = true;
    for (std::size_t channel = 0; channel < channels; ++channel) {
      out[channel] = (*this)(in[channel % used]);
      has_data = has_data && !std::isnan(out[channel]);
    }
    if (!has_data) std::fill_n(out, channels, kNaN);
    if (census == nullptr) continue;
    ++census->nodes;
    if (!has_data) {
      ++census->gaps;
      continue;
    }
    if (meaning_ == MapMeaning::kHeight) take_extremes(out[0], in[0], *census);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      census->min = std::min(census->min, out[channel]);
      census->max = std::max(census->max, out[channel]);
    }
    if (!clamps) continue;
    const double value = quantity(in[0]);
    census->least_quantity = std::min(census->least_quantity, value);
    census->most_quantity = std::max(census->most_quantity, value);
    if (value < low || value > high) ++census->out_of_range;
  }
}

}  // namespace prairie
