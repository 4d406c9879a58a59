#include "maps/value_mapping.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/error.h"
#include "pictures/srgb.h"

namespace prairie {
namespace {

constexpr double kCustomaryNodata = -9999.0;
constexpr float kHugeNodata = 3.4e38f;
constexpr double kMaxDensity = 1e5;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A nodata value as a file of the given type can hold it.
double stored(double nodata, SampleType type) {
  if (type.is_integer()) return nodata;
  const float value = static_cast<float>(nodata);
  if (type.bits != 16) return static_cast<double>(value);
  std::uint16_t half = 0;
  float rounded = 0.0f;
  OIIO::convert_types(OIIO::TypeDesc::FLOAT, &value, OIIO::TypeDesc::HALF, &half, 1);
  OIIO::convert_types(OIIO::TypeDesc::HALF, &half, OIIO::TypeDesc::FLOAT, &rounded, 1);
  return static_cast<double>(rounded);
}

}  // namespace

ValueMapping::ValueMapping(const MapSpec& spec, MapMeaning meaning, SampleType type,
                           std::optional<double> file_nodata)
    : meaning_(meaning), type_(type) {
  const auto fail = [&spec](const std::string& found, const std::string& expected) {
    throw BadInput(spec.file.string(), spec.field, found, expected);
  };
  nodata_.push_back(stored(kCustomaryNodata, type));
  const std::optional<double> nodata = spec.nodata ? spec.nodata : file_nodata;
  if (nodata && std::isfinite(*nodata)) nodata_.push_back(stored(*nodata, type));

  if (spec.range) {
    const auto [low, high] = *spec.range;
    if (!std::isfinite(low) || !std::isfinite(high) || low == high) {
      fail(fmt::format("`range` of {}, {}", low, high), "two different finite numbers");
    }
    low_ = low;
    high_ = high;
  }
  switch (meaning) {
    case MapMeaning::kHeight:
      if (!type.is_integer()) break;
      if (!spec.range) {
        fail(fmt::format("heights as {}-bit integers", type.bits),
             fmt::format("`range`, the heights in metres of the values 0 and {:.0f}", type.largest));
      }
      if (std::max(std::abs(low_), std::abs(high_)) > static_cast<double>(kMaxHeight_m)) {
        fail(fmt::format("`range` of {}, {} m", low_, high_),
             fmt::format("heights within ±{:.0f} m", kMaxHeight_m));
      }
      break;
    case MapMeaning::kDensity:
    case MapMeaning::kFactor:
      if (!spec.range) high_ = type.is_integer() ? type.largest : 1.0;
      if (!(spec.max >= 0.0 && spec.max <= kMaxDensity)) {
        fail(fmt::format("`max` of {}", spec.max), fmt::format("a number from 0 to {:.0f}", kMaxDensity));
      }
      max_ = spec.max;
      if (meaning == MapMeaning::kFactor) break;
      if (!(spec.curve > 0.0) || !std::isfinite(spec.curve)) {
        fail(fmt::format("`curve` of {}", spec.curve), "a finite number above 0");
      }
      curve_ = spec.curve;
      break;
    case MapMeaning::kColor:
      break;
  }
}

double ValueMapping::raw(float sample) const {
  if (!type_.is_integer()) return static_cast<double>(sample);
  const double value = static_cast<double>(sample) * type_.largest;
  // A float holds every quotient of 16 bits exactly enough to get the integer back; of 32 bits it does not.
  return type_.bits <= 16 ? std::nearbyint(value) : value;
}

bool ValueMapping::is_nodata(float sample) const {
  if (!(std::abs(sample) < kHugeNodata)) return true;  // NaN and infinities too
  const double value = raw(sample);
  const bool blurred = type_.is_integer() && type_.bits > 16;
  for (const double nodata : nodata_) {
    const double tolerance = blurred ? std::max(0.5, std::abs(nodata) * 0x1p-23) : 0.0;
    if (std::abs(value - nodata) <= tolerance) return true;
  }
  return false;
}

float ValueMapping::operator()(float sample) const {
  if (is_nodata(sample)) return kNaN;
  switch (meaning_) {
    case MapMeaning::kHeight:
      if (!type_.is_integer()) return sample;
      return static_cast<float>(low_ + (high_ - low_) * (raw(sample) / type_.largest));
    case MapMeaning::kDensity:
    case MapMeaning::kFactor: {
      const double share = std::clamp((raw(sample) - low_) / (high_ - low_), 0.0, 1.0);
      return static_cast<float>(max_ * (curve_ == 1.0 ? share : std::pow(share, curve_)));
    }
    case MapMeaning::kColor:
      return type_.is_integer() && type_.bits <= 16 ? linear_from_srgb(std::max(sample, 0.0f)) : sample;
  }
  return kNaN;
}

void ValueMapping::map_pixels(std::span<const float> samples, int sample_channels, int value_channels,
                              std::span<float> values, ValueCensus* census) const {
  const std::size_t stride = static_cast<std::size_t>(sample_channels);
  const std::size_t channels = static_cast<std::size_t>(value_channels);
  const std::size_t used = std::min(stride, channels);
  const std::size_t pixels = samples.size() / stride;
  const bool clamps = meaning_ == MapMeaning::kDensity || meaning_ == MapMeaning::kFactor;
  // A limit that someone wrote in decimals must not exclude the float nearest to it.
  const double slack = 1e-6 * std::abs(high_ - low_);
  const double low = std::min(low_, high_) - slack;
  const double high = std::max(low_, high_) + slack;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const float* in = samples.data() + pixel * stride;
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
    for (std::size_t channel = 0; channel < channels; ++channel) {
      census->min = std::min(census->min, out[channel]);
      census->max = std::max(census->max, out[channel]);
    }
    if (clamps && (raw(in[0]) < low || raw(in[0]) > high)) ++census->out_of_range;
  }
}

}  // namespace prairie
