#include "maps/map_decoding.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "files/error.h"
#include "files/input_file.h"
#include "maps/map_channels.h"
#include "maps/map_files.h"
#include "maps/map_placement.h"
#include "maps/map_warnings.h"
#include "maps/resampling.h"
#include "maps/stored_georaster.h"
#include "maps/stored_images.h"
#include "maps/value_mapping.h"

namespace prairie {
namespace {

constexpr double kMaxSpacing_m = 1e6;

void check_spec(const MapSpec& spec) {
  if (spec.spacing_m && !(*spec.spacing_m > 0.0 && *spec.spacing_m <= kMaxSpacing_m)) {
    throw BadInput(spec.file.string(), spec.field, fmt::format("`spacing_m` of {}", *spec.spacing_m),
                   fmt::format("metres, above 0 and at most {:.0f}", kMaxSpacing_m));
  }
}

/// Between a raster and the nodes of its map: which channels, what they mean, and what was seen of them.
class MapPixels {
 public:
  MapPixels(const StoredRaster& raster, const MapRequest& request)
      : raster_(raster),
        spec_(request.spec),
        meaning_(request.meaning),
        channels_(choose_channels(raster, request.spec, request.meaning)),
        channel_(raster.channels()[static_cast<std::size_t>(channels_.run.first)]),
        mapping_(request.spec, request.meaning, channel_) {}

  int value_channels() const { return meaning_ == MapMeaning::kColor ? 3 : 1; }
  ChannelRun run() const { return channels_.run; }
  const StoredChannel& channel() const { return channel_; }
  const ValueMapping& mapping() const { return mapping_; }
  const ValueCensus& census() const { return census_; }

  /// The values of pixels, channels interleaved.
  std::vector<float> values_of(std::span<const double> stored) {
    if (channels_.must_equal &&
        !all_grey(channels_, channel_.type.is_integer() ? channel_.type.largest : 1.0, stored))
      throw ambiguous_channels(raster_, spec_);
    std::vector<float> values(stored.size() / static_cast<std::size_t>(channels_.run.count) *
                              static_cast<std::size_t>(value_channels()));
    mapping_.map_pixels(stored, channels_.run.count, value_channels(), values, &census_);
    return values;
  }

  /// A range of heights of floating-point numbers holds for those of 0 to 1, as terrain tools write them;
  /// others are metres as they are. True where it is dropped for that.
  bool drop_range_unless_normalised(StoredRaster& raster) {
    if (meaning_ != MapMeaning::kHeight || !spec_.range || channel_.type.is_integer()) return false;
    MapSpec plain = spec_;
    plain.range.reset();
    const ValueMapping as_stored(plain, meaning_, channel_);
    ValueCensus census;
    std::vector<float> values;
    raster.read(channels_.run, [&](const PixelRect&, std::span<const double> stored) {
      values.resize(stored.size() / static_cast<std::size_t>(channels_.run.count));
      as_stored.map_pixels(stored, channels_.run.count, 1, values, &census);
    });
    constexpr float kSlack = 0.05f;  // filters overshoot
    if (census.min >= -kSlack && census.max <= 1.0f + kSlack) return false;
    mapping_ = as_stored;
    return true;
  }

 private:
  const StoredRaster& raster_;
  const MapSpec& spec_;
  MapMeaning meaning_;
  MapChannels channels_;
  StoredChannel channel_;
  ValueMapping mapping_;
  ValueCensus census_;
};

/// Of an image whose heights nobody has told the meaning of, and which look as if they had to be stretched.
std::string note_on_normalised(const MapRequest& request, const MapPixels& pixels, bool is_placed) {
  const MapSpec& spec = request.spec;
  const bool may_be = request.meaning == MapMeaning::kHeight && !spec.range && !spec.scale && !is_placed &&
                      !pixels.channel().type.is_integer();
  if (!may_be || pixels.census().min < 0.0f || pixels.census().max > 1.0f) return "";
  return "the heights lie between 0 and 1 m, as terrain tools write shares of a range: `range` tells the "
         "metres "
         "of 0 and 1";
}

/// Values of a rectangle of pixels in the order of nodes.
std::vector<float> as_nodes(const MetricGrid& grid, const PixelRect& rect, int channels,
                            std::vector<float> values) {
  const auto stride = static_cast<std::ptrdiff_t>(channels);
  const std::ptrdiff_t row_values = rect.width * stride;
  std::vector<float> result(values.size());
  for (int row = 0; row < rect.height; ++row) {
    const int from = grid.rows_run_north ? row : rect.height - 1 - row;
    const auto first = values.begin() + from * row_values;
    const auto to = result.begin() + row * row_values;
    if (!grid.columns_run_west) {
      std::copy(first, first + row_values, to);
      continue;
    }
    for (int column = 0; column < rect.width; ++column)
      std::copy_n(first + (rect.width - 1 - column) * stride, channels, to + column * stride);
  }
  return result;
}

NodeRect node_rect(const MetricGrid& grid, const PixelRect& rect) {
  return {grid.columns_run_west ? grid.columns - rect.x - rect.width : rect.x,
          grid.rows_run_north ? rect.y : grid.rows - rect.y - rect.height, rect.width, rect.height};
}

/// Counts what passes, where the nodes are not the pixels that were counted.
class CountingSink : public MapSink {
 public:
  CountingSink(MapSink& sink, int channels) : sink_(sink), channels_(channels) {}
  void begin(const GridFrame& frame, int channels) override { sink_.begin(frame, channels); }
  void take(const NodeRect& rect, std::span<const float> values) override {
    for (std::size_t k = 0; k < values.size(); k += static_cast<std::size_t>(channels_)) {
      ++nodes;
      if (std::isnan(values[k])) ++gaps;
    }
    sink_.take(rect, values);
  }

  std::uint64_t nodes = 0;
  std::uint64_t gaps = 0;

 private:
  MapSink& sink_;
  int channels_;
};

/// All pixels at once, for rasters that can only be read from one end to the other.
PixelWindow window_of_whole(StoredRaster& raster, MapPixels& pixels) {
  const int channels = pixels.value_channels();
  auto whole = std::make_shared<std::vector<float>>(static_cast<std::size_t>(raster.columns()) *
                                                    static_cast<std::size_t>(raster.rows()) *
                                                    static_cast<std::size_t>(channels));
  const auto at = [width = raster.columns(), channels](int x, int y) {
    return (static_cast<std::ptrdiff_t>(y) * width + x) * channels;
  };
  raster.read(pixels.run(), [&](const PixelRect& rect, std::span<const double> stored) {
    const std::vector<float> values = pixels.values_of(stored);
    for (int row = 0; row < rect.height; ++row) {
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row) * rect.width * channels,
                  rect.width * channels, whole->begin() + at(rect.x, rect.y + row));
    }
  });
  return [whole, at, channels](const PixelRect& rect) {
    std::vector<float> result;
    for (int row = 0; row < rect.height; ++row) {
      const auto first = whole->begin() + at(rect.x, rect.y + row);
      result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(rect.width) * channels);
    }
    return result;
  };
}

MapSummary decode(StoredRaster& raster, const StoredGeoraster* windowed, const MapRequest& request,
                  const MapPlacement& placement, MapSink& sink) {
  MapPixels pixels(raster, request);
  const bool dropped_range = pixels.drop_range_unless_normalised(raster);
  const MetricGrid& grid = placement.grid;
  const int channels = pixels.value_channels();
  sink.begin({.columns = grid.columns,
              .rows = grid.rows,
              .spacing_m = grid.spacing_m,
              .origin_m = glm::dvec2(0.0),
              .repeats = request.spec.repeats},
             channels);
  CountingSink counted(sink, channels);
  if (!grid.is_resampled) {
    raster.read(pixels.run(), [&](const PixelRect& rect, std::span<const double> stored) {
      counted.take(node_rect(grid, rect), as_nodes(grid, rect, channels, pixels.values_of(stored)));
    });
  } else if (windowed != nullptr) {
    resample(
        placement, channels,
        [&](const PixelRect& rect) { return pixels.values_of(windowed->read_window(rect, pixels.run())); },
        counted);
  } else {
    resample(placement, channels, window_of_whole(raster, pixels), counted);
  }
  ValueCensus census = pixels.census();
  check_census(request.spec, request.meaning, census);
  MapSummary summary;
  summary.geo_reference = placement.geo_reference;
  summary.has_gaps = counted.gaps > 0;
  const double seen_share =
      census.nodes == 0 ? 0.0 : static_cast<double>(counted.nodes) / static_cast<double>(census.nodes);
  census.out_of_range = static_cast<std::uint64_t>(static_cast<double>(census.out_of_range) * seen_share);
  census.nodes = counted.nodes;
  census.gaps = counted.gaps;
  summary.warnings = map_warnings(request.spec, request.meaning, census, grid.spacing_m);
  const auto note = [&](const char* code, const std::string& text) {
    if (!text.empty()) summary.warnings.push_back(map_note(request.spec, code, text));
  };
  note("resampled", grid.note);
  note("scale-set-aside", pixels.mapping().note());
  note("normalised", note_on_normalised(request, pixels, placement.geo_reference.has_value()));
  if (dropped_range) note("range-not-used", "`range` is not used: the heights are metres, not 0 to 1");
  return summary;
}

int ignore_message(TIFF*, void*, const char*, const char*, va_list) {
  return 1;
}

/// Of a TIFF; GDAL does not turn upright what is stored turned.
bool is_stored_turned(const std::filesystem::path& path) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  constexpr tmsize_t kMaxAllocationBytes = tmsize_t{1} << 28;
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxAllocationBytes);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignore_message, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  // Not mapped into memory: a file that shrinks meanwhile would end the process.
  const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpenExt(path.c_str(), "rm", options.get()),
                                                         TIFFClose);
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  return tiff != nullptr && TIFFGetField(tiff.get(), TIFFTAG_ORIENTATION, &orientation) != 0 &&
         orientation != ORIENTATION_TOPLEFT;
}

/// A map's raster, opened; one of the two kinds.
struct OpenMap {
  MapRequest request;  // of the first file
  std::vector<std::filesystem::path> files;
  std::unique_ptr<Georaster> georaster;
  std::unique_ptr<StoredRaster> image;
  std::uint64_t image_hash = 0;
};

void open_image_of(OpenMap& map) {
  const MapSpec& spec = map.request.spec;
  const InputFile input = inspect_input(spec.file, spec.field);
  map.georaster.reset();
  map.image = open_image(spec, input.bytes);
  map.image_hash = input.hash;
}

OpenMap open_map(const MapRequest& request) {
  check_spec(request.spec);
  OpenMap map{.request = request, .files = files_of_map(request.spec), .georaster = {}, .image = {}};
  MapSpec& spec = map.request.spec;
  spec.file = map.files.front();
  for (const std::filesystem::path& file : map.files) check_input(file, spec.field);
  if (spec.size_px || !is_georaster(spec.file)) {
    if (map.files.size() > 1) {
      throw BadInput(spec.file.string(), spec.field, "an image as part of a mosaic",
                     "rasters that tell their places: GeoTIFF, .asc, .hgt");
    }
    open_image_of(map);
    return map;
  }
  map.georaster = std::make_unique<Georaster>(map.files, spec.field);
  const bool is_mere_image =
      map.files.size() == 1 && !map.georaster->map_from_pixel() && !map.georaster->has_control_points();
  if (is_mere_image && is_stored_turned(spec.file)) open_image_of(map);
  return map;
}

MapPlacement placement_of(const OpenMap& map) {
  const MapRequest& request = map.request;
  if (map.georaster != nullptr) return place_georaster(request.spec, *map.georaster, request.scene_wkt);
  return place_image(request.spec, map.image->columns(), map.image->rows(), request.scene_wkt);
}

}  // namespace

MapLayout layout_of_map(const MapRequest& request) {
  OpenMap map = open_map(request);
  const bool is_told = request.spec.spacing_m.has_value();
  // Any spacing serves to find out whether the file has one of its own.
  if (!is_told) map.request.spec.spacing_m = 1.0;
  MapPlacement placement = placement_of(map);
  if (placement.geo_reference && !is_told) {
    map.request.spec.spacing_m.reset();
    placement = placement_of(map);
  }
  const MetricGrid& grid = placement.grid;
  MapLayout layout{
      .columns = grid.columns, .rows = grid.rows, .spacing_m = {}, .geo_reference = placement.geo_reference};
  if (is_told || placement.geo_reference) layout.spacing_m = grid.spacing_m;
  return layout;
}

MapSummary decode_map(const MapRequest& request, MapSink& sink) {
  const OpenMap map = open_map(request);
  const MapPlacement placement = placement_of(map);
  if (map.georaster == nullptr) {
    MapSummary summary = decode(*map.image, nullptr, map.request, placement, sink);
    summary.content_hash = map.image_hash;
    return summary;
  }
  StoredGeoraster stored(*map.georaster, map.request.spec, request.meaning);
  MapSummary summary = decode(stored, &stored, map.request, placement, sink);
  summary.content_hash = content_hash(map.georaster->files(), request.spec.field);
  return summary;
}

}  // namespace prairie
