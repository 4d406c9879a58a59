#include "maps/map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/error.h"
#include "files/input_file.h"
#include "maps/cached_raster.h"
#include "maps/geo_tags.h"
#include "maps/map_channels.h"
#include "maps/map_placement.h"
#include "maps/value_mapping.h"
#include "pictures/raster_file.h"

namespace prairie {
namespace {

constexpr double kMaxSpacing_m = 1e6;
constexpr double kWorthAWarning = 0.01;  // share of the nodes

void check_spacing(const MapSpec& spec) {
  if (!spec.spacing_m || (*spec.spacing_m > 0.0 && *spec.spacing_m <= kMaxSpacing_m)) return;
  throw BadInput(spec.file.string(), spec.field, fmt::format("`spacing_m` of {}", *spec.spacing_m),
                 fmt::format("metres, above 0 and at most {:.0f}", kMaxSpacing_m));
}

/// Reads every pixel, checks it, and keeps the values in `values` (rows from south) unless it is empty.
ValueCensus read_values(RasterFile& file, const MapSpec& spec, const MapChannels& channels,
                        const ValueMapping& mapping, int value_channels, std::span<float> values) {
  ValueCensus census;
  std::vector<float> mapped;
  file.read(channels.run, [&](const PixelRect& rect, std::span<const float> samples) {
    if (channels.must_equal && !all_grey(channels, samples)) throw ambiguous_channels(file, spec);
    const std::size_t row_values =
        static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(value_channels);
    mapped.resize(row_values * static_cast<std::size_t>(rect.height));
    mapping.map_pixels(samples, channels.run.count, value_channels, mapped, &census);
    if (values.empty()) return;
    for (int row = 0; row < rect.height; ++row) {
      const std::size_t node_row = static_cast<std::size_t>(file.rows() - 1 - rect.y - row);
      const std::size_t first =
          node_row * static_cast<std::size_t>(file.columns()) + static_cast<std::size_t>(rect.x);
      std::copy_n(mapped.data() + static_cast<std::size_t>(row) * row_values, row_values,
                  values.data() + first * static_cast<std::size_t>(value_channels));
    }
  });
  return census;
}

void check_values(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census) {
  if (census.gaps == census.nodes) {
    throw BadInput(spec.file.string(), spec.field, "no pixel with data", "at least one");
  }
  if (meaning != MapMeaning::kHeight) return;
  for (const float height_m : {census.min, census.max}) {
    if (std::abs(height_m) <= kMaxHeight_m) continue;
    throw BadInput(
        spec.file.string(), spec.field, fmt::format("a height of {} m", height_m),
        fmt::format("heights within ±{:.0f} m, or `nodata` naming the value that means none", kMaxHeight_m));
  }
}

std::vector<std::string> warnings_about(const MapSpec& spec, MapMeaning meaning, SampleType type,
                                        const ValueCensus& census) {
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    warnings.push_back(fmt::format("{}: {}: {}", spec.file.string(), spec.field, text));
  };
  const double nodes = static_cast<double>(census.nodes);
  const double gap_share = static_cast<double>(census.gaps) / nodes;
  const double outside_share = static_cast<double>(census.out_of_range) / nodes;
  if (gap_share > kWorthAWarning) warn(fmt::format("{:.1f} % of the nodes have no data", 100.0 * gap_share));
  if (outside_share > kWorthAWarning) {
    warn(fmt::format("{:.1f} % of the values lie outside the range and are clamped", 100.0 * outside_share));
  }
  if (census.min == census.max) {
    const bool nothing_grows = meaning == MapMeaning::kDensity && census.max == 0.0f;
    warn(nothing_grows ? "the density is zero everywhere: nothing grows"
                       : fmt::format("every node has the same value, {}", census.max));
  }
  if (meaning == MapMeaning::kHeight && spec.range && !type.is_integer()) {
    warn("`range` is not used: heights in a floating-point file are metres");
  }
  return warnings;
}

}  // namespace

Map read_map(const MapSpec& spec, MapMeaning meaning, std::uint64_t budget_bytes) {
  check_spacing(spec);
  const InputFile input = inspect_input(spec.file, spec.field);
  RasterFile file(spec.file, spec.field, input.bytes);
  const std::optional<GeoTags> tags = read_geo_tags(spec.file);
  MapPlacement placement = place_map(spec, tags ? &*tags : nullptr, file.rows());
  const MapChannels channels = choose_channels(file, spec, meaning);
  const SampleType type = file.sample_type(channels.run.first);
  const ValueMapping mapping(spec, meaning, type, tags ? tags->nodata : std::nullopt);

  const int value_channels = meaning == MapMeaning::kColor ? 3 : 1;
  const GridFrame frame{.columns = file.columns(),
                        .rows = file.rows(),
                        .spacing_m = placement.spacing_m,
                        .origin_m = glm::dvec2(0.0),
                        .repeats = spec.repeats};
  const std::uint64_t value_count = static_cast<std::uint64_t>(file.columns()) *
                                    static_cast<std::uint64_t>(file.rows()) *
                                    static_cast<std::uint64_t>(value_channels);
  const bool fits = value_count * sizeof(float) <= budget_bytes;

  std::vector<float> values(fits ? value_count : 0);
  const ValueCensus census = read_values(file, spec, channels, mapping, value_channels, values);
  check_values(spec, meaning, census);

  Map map;
  if (fits) {
    map.grid = NodeGrid(frame, value_channels, std::move(values));
  } else {
    // Of equal channels the first is as good as any.
    const int file_channels = channels.must_equal ? 1 : channels.run.count;
    map.grid =
        NodeGrid(frame, value_channels,
                 make_cached_raster({spec, file.spec(), {channels.run.first, file_channels}, value_channels},
                                    mapping, budget_bytes),
                 census.gaps > 0);
  }
  map.geo_reference = std::move(placement.geo_reference);
  map.content_hash = input.hash;
  map.warnings = warnings_about(spec, meaning, type, census);
  return map;
}

}  // namespace prairie
