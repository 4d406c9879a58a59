#include "maps/stored_georaster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::uint64_t kChunkBytes = std::uint64_t{16} << 20;

struct LengthUnit {
  std::string_view name;
  double metres;
};

// As GDAL, PROJ and the makers of height rasters write them.
constexpr std::array kLengthUnits{
    LengthUnit{"m", 1.0},
    LengthUnit{"metre", 1.0},
    LengthUnit{"meter", 1.0},
    LengthUnit{"metres", 1.0},
    LengthUnit{"meters", 1.0},
    LengthUnit{"cm", 0.01},
    LengthUnit{"centimetre", 0.01},
    LengthUnit{"centimeter", 0.01},
    LengthUnit{"dm", 0.1},
    LengthUnit{"decimetre", 0.1},
    LengthUnit{"mm", 0.001},
    LengthUnit{"millimetre", 0.001},
    LengthUnit{"km", 1000.0},
    LengthUnit{"kilometre", 1000.0},
    LengthUnit{"ft", 0.3048},
    LengthUnit{"foot", 0.3048},
    LengthUnit{"feet", 0.3048},
    LengthUnit{"international foot", 0.3048},
    LengthUnit{"us survey foot", 1200.0 / 3937.0},
    LengthUnit{"us survey feet", 1200.0 / 3937.0},
    LengthUnit{"us-ft", 1200.0 / 3937.0},
    LengthUnit{"ftus", 1200.0 / 3937.0},
    LengthUnit{"foot_us", 1200.0 / 3937.0},
    LengthUnit{"us foot", 1200.0 / 3937.0},
    LengthUnit{"yd", 0.9144},
    LengthUnit{"yard", 0.9144},
    LengthUnit{"fathom", 1.8288},
};

std::optional<double> metres_of(std::string unit) {
  std::ranges::transform(unit, unit.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const LengthUnit& known : kLengthUnits) {
    if (known.name == unit) return known.metres;
  }
  return std::nullopt;
}

/// Metres per unit of a band of heights.
double height_unit_m(const Georaster& raster, const Band& band, const MapSpec& spec) {
  if (spec.scale || spec.range) return 1.0;  // the scene says it
  if (!band.unit.empty()) {
    if (const std::optional<double> metres = metres_of(band.unit)) return *metres;
    throw BadInput(spec.file.string(), spec.field, fmt::format("heights in \"{:.60}\"", band.unit),
                   "a unit of length, or `scale`, the metres of one such unit");
  }
  if (raster.reference()) {
    if (const auto metres = raster.reference()->vertical_metres_per_unit()) return *metres;
  }
  return 1.0;
}

StoredChannel channel_of(const Band& band) {
  return {.name = band.name,
          .type = band.type,
          .nodata = band.nodata,
          .has_scale = band.has_scale,
          .scale = band.scale,
          .offset = band.offset};
}

}  // namespace

StoredGeoraster::StoredGeoraster(const Georaster& raster, const MapSpec& spec, MapMeaning meaning)
    : raster_(raster) {
  const std::vector<Band>& bands = raster.bands();
  const bool is_chosen = spec.channel.has_value();
  is_palette_ =
      bands.size() == 1 && !bands[0].palette.empty() && !is_chosen && meaning != MapMeaning::kHeight;
  if (is_palette_) {
    for (const char* name : {"R", "G", "B"}) channels_.push_back({.name = name, .type = {8, 255.0}});
    return;
  }
  const bool is_placed = raster.map_from_pixel().has_value();
  for (std::size_t k = 0; k < bands.size(); ++k) {
    StoredChannel channel = channel_of(bands[k]);
    if (meaning == MapMeaning::kHeight && !bands[k].is_alpha)
      channel.metres_per_unit = height_unit_m(raster, bands[k], spec);
    // Integers of a survey are metres; those of an image are shares of a range that somebody must tell.
    channel.is_measured = is_placed || channel.has_scale || !bands[k].unit.empty();
    channels_.push_back(std::move(channel));
  }
  // Of a raster with a place, alpha is validity, which reading obeys; of an image it may be anything.
  if (bands.size() < 2 || !bands.back().is_alpha) return;
  if (!is_placed) {
    alpha_channel_ = static_cast<int>(bands.size()) - 1;
  } else if (!is_chosen) {
    channels_.pop_back();
  }
}

std::vector<double> StoredGeoraster::read_window(const PixelRect& rect, ChannelRun channels) const {
  const std::size_t pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  const auto stride = static_cast<std::size_t>(channels.count);
  std::vector<double> band(pixels);
  if (is_palette_) {
    std::vector<double> result(pixels * stride, std::numeric_limits<double>::quiet_NaN());
    raster_.read(rect, 0, band);
    const auto& palette = raster_.bands()[0].palette;
    for (std::size_t k = 0; k < pixels; ++k) {
      if (!(band[k] >= 0.0 && band[k] < static_cast<double>(palette.size()))) continue;
      for (std::size_t c = 0; c < stride; ++c)
        result[k * stride + c] =
            palette[static_cast<std::size_t>(band[k])][static_cast<std::size_t>(channels.first) + c];
    }
    return result;
  }
  if (stride == 1) {
    raster_.read(rect, channels.first, band);
    return band;
  }
  std::vector<double> result(pixels * stride);
  for (std::size_t c = 0; c < stride; ++c) {
    raster_.read(rect, channels.first + static_cast<int>(c), band);
    for (std::size_t k = 0; k < pixels; ++k) result[k * stride + c] = band[k];
  }
  return result;
}

void StoredGeoraster::read(ChannelRun channels, const Sink& sink) {
  const std::uint64_t row_bytes =
      sizeof(double) * static_cast<std::uint64_t>(columns()) * static_cast<std::uint64_t>(channels.count);
  const int block_rows = std::clamp(raster_.block_rows(), 1, rows());
  // Whole blocks, so that none is decoded twice.
  const auto blocks =
      std::max<std::uint64_t>(1, kChunkBytes / (row_bytes * static_cast<std::uint64_t>(block_rows)));
  const int chunk_rows = static_cast<int>(std::min<std::uint64_t>(
      static_cast<std::uint64_t>(rows()), blocks * static_cast<std::uint64_t>(block_rows)));
  for (int row = 0; row < rows(); row += chunk_rows) {
    const PixelRect rect{0, row, columns(), std::min(chunk_rows, rows() - row)};
    sink(rect, read_window(rect, channels));
  }
}

}  // namespace prairie
