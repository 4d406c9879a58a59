#include "pictures/raster_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "files/error.h"
#include "files/quiet_stderr.h"
#include "pictures/eager_formats.h"
#include "pictures/exr_header.h"

namespace prairie {
namespace {

constexpr int kMaxSide = 1'000'000;
constexpr int kMaxChannels = 16;
constexpr std::uint64_t kMaxTileBytes = std::uint64_t{64} << 20;
constexpr std::uint64_t kChunkBytes = std::uint64_t{16} << 20;

// Deflate cannot shrink anything more than 1032-fold; a file that claims more than this, and enough to hurt,
// lies.
constexpr std::uint64_t kMaxExpansion = 1100;
constexpr std::uint64_t kHarmlessBytes = std::uint64_t{64} << 20;

bool is_bomb(std::uint64_t claimed_bytes, std::uint64_t file_bytes) {
  return claimed_bytes > kHarmlessBytes && claimed_bytes / kMaxExpansion > file_bytes;
}

constexpr const char* kWholeImage = "a complete image of a format that OpenImageIO reads";

/// Runs a call into OpenImageIO, whose plug-ins let exceptions of the libraries below them escape.
template <class Call>
bool succeeds(const Call& call, std::string* error) {
  const QuietStderr quiet;
  try {
    return call();
  } catch (const std::exception& exception) {
    *error = exception.what();
    return false;
  }
}

PixelRect common_part(const PixelRect& a, const PixelRect& b) {
  const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
  return {left, top, std::min(a.x + a.width, b.x + b.width) - left,
          std::min(a.y + a.height, b.y + b.height) - top};
}

/// The samples of `part` of `rect`.
std::vector<float> cut(const PixelRect& rect, const PixelRect& part, std::span<const float> samples,
                       int channels) {
  std::vector<float> result;
  const auto stride = static_cast<std::size_t>(channels);
  for (int row = 0; row < part.height; ++row) {
    const std::size_t first =
        static_cast<std::size_t>(part.y - rect.y + row) * static_cast<std::size_t>(rect.width) +
        static_cast<std::size_t>(part.x - rect.x);
    const std::span<const float> line =
        samples.subspan(first * stride, static_cast<std::size_t>(part.width) * stride);
    result.insert(result.end(), line.begin(), line.end());
  }
  return result;
}

}  // namespace

RasterFile::RasterFile(const std::filesystem::path& path, const std::string& field, std::uint64_t file_bytes)
    : path_(path), field_(field) {
  if (!exr_header_fits(path, file_bytes)) fail("a header that claims more than the file holds", kWholeImage);
  const std::uint64_t claimed_bytes = eagerly_claimed_bytes(path);
  if (is_bomb(claimed_bytes, file_bytes)) {
    fail(fmt::format("a claim of {} MB of pixels in {} bytes", claimed_bytes >> 20, file_bytes),
         "a file that can hold the pixels it claims");
  }
  OIIO::ImageSpec config;
  // Data are not colours behind a veil: multiplying them by alpha, as the default does, loses them.
  config.attribute("oiio:UnassociatedAlpha", 1);
  std::string error;
  const bool opened = succeeds(
      [&] {
        input_ = OIIO::ImageInput::open(path.string(), &config);
        return input_ != nullptr;
      },
      &error);
  if (!opened) {
    const std::string reason = OIIO::geterror();
    fail(reason.empty() ? error : reason, kWholeImage);
  }
  spec_ = input_->spec();
  check_claims(file_bytes);
  look_at_layout();
}

RasterFile::~RasterFile() {
  // OpenImageIO prints errors that nobody fetched.
  if (input_ != nullptr) input_->geterror();
}

void RasterFile::fail(const std::string& found, const std::string& expected) const {
  throw BadInput(path_.string(), field_, found.empty() ? "something unreadable" : found, expected);
}

void RasterFile::check_claims(std::uint64_t file_bytes) const {
  const OIIO::ImageSpec& s = spec_;
  if (s.width < 1 || s.height < 1 || s.width > kMaxSide || s.height > kMaxSide) {
    fail(fmt::format("a claim of {} × {} pixels", s.width, s.height),
         fmt::format("1 to {} pixels a side", kMaxSide));
  }
  if (s.depth > 1 || s.deep) fail("a volume or a deep image", "one value per pixel and channel");
  if (s.nchannels < 1 || s.nchannels > kMaxChannels) {
    fail(fmt::format("a claim of {} channels", s.nchannels), fmt::format("1 to {} channels", kMaxChannels));
  }
  const std::uint64_t pixel_bytes = s.pixel_bytes(true);
  if (pixel_bytes == 0) fail("samples of an unknown type", "8-, 16- or 32-bit integers, half or float");
  const std::uint64_t claimed_bytes =
      pixel_bytes * static_cast<std::uint64_t>(s.width) * static_cast<std::uint64_t>(s.height);
  if (is_bomb(claimed_bytes, file_bytes)) {
    fail(fmt::format("a claim of {} × {} pixels ({} MB) in {} bytes", s.width, s.height, claimed_bytes >> 20,
                     file_bytes),
         "a file that can hold the pixels it claims");
  }
  if (s.tile_width < 0 || s.tile_height < 0 || (s.tile_width > 0) != (s.tile_height > 0) ||
      pixel_bytes * static_cast<std::uint64_t>(s.tile_width) * static_cast<std::uint64_t>(s.tile_height) >
          kMaxTileBytes) {
    fail(fmt::format("tiles of {} × {} pixels", s.tile_width, s.tile_height),
         fmt::format("tiles of at most {} MB", kMaxTileBytes >> 20));
  }
}

void RasterFile::look_at_layout() {
  data_window_ = {0, 0, spec_.width, spec_.height};
  orientation_ = {spec_.get_int_attribute("Orientation", 1), spec_.width, spec_.height};
  const bool has_display_window = std::string_view(input_->format_name()) == "openexr";
  if (!has_display_window) return;
  const std::int64_t x = std::int64_t{spec_.x} - spec_.full_x, y = std::int64_t{spec_.y} - spec_.full_y;
  if (spec_.full_width < 1 || spec_.full_height < 1 || spec_.full_width > kMaxSide ||
      spec_.full_height > kMaxSide)
    fail(fmt::format("a picture of {} × {} pixels", spec_.full_width, spec_.full_height),
         fmt::format("1 to {} pixels a side", kMaxSide));
  if (std::abs(x) > kMaxSide || std::abs(y) > kMaxSide)
    fail(fmt::format("pixels {}, {} beyond the picture", x, y), "pixels within the picture");
  const std::uint64_t picture_pixels =
      static_cast<std::uint64_t>(spec_.full_width) * static_cast<std::uint64_t>(spec_.full_height);
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(spec_.width) * static_cast<std::uint64_t>(spec_.height);
  constexpr std::uint64_t kMostMargin = 256;  // times the pixels that there are
  if (picture_pixels > kHarmlessBytes && picture_pixels / kMostMargin > pixels)
    fail(fmt::format("{} × {} pixels in a picture of {} × {}", spec_.width, spec_.height, spec_.full_width,
                     spec_.full_height),
         "pixels that fill the picture");
  data_window_.x = static_cast<int>(x);
  data_window_.y = static_cast<int>(y);
  orientation_.stored_columns = spec_.full_width;
  orientation_.stored_rows = spec_.full_height;
}

SampleType RasterFile::sample_type(int channel) const {
  const OIIO::TypeDesc type = spec_.channelformat(channel);
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      return {8, 255.0};
    case OIIO::TypeDesc::INT8:
      return {8, 127.0};
    case OIIO::TypeDesc::UINT16:
      return {16, 65535.0};
    case OIIO::TypeDesc::INT16:
      return {16, 32767.0};
    case OIIO::TypeDesc::UINT32:
      return {32, 4294967295.0};
    case OIIO::TypeDesc::INT32:
      return {32, 2147483647.0};
    case OIIO::TypeDesc::HALF:
      return {16, 0.0};
    case OIIO::TypeDesc::FLOAT:
      return {32, 0.0};
    case OIIO::TypeDesc::DOUBLE:
      // OpenImageIO 2.4 reads a TIFF of doubles as zeros, and says that all went well.
      fail("samples of 64 bits", "8-, 16- or 32-bit integers, half or float");
    default:
      fail(fmt::format("samples of type {}", type.c_str()), "8-, 16- or 32-bit integers, half or float");
  }
}

std::string RasterFile::channel_list() const {
  std::string list;
  for (int channel = 0; channel < spec_.nchannels; ++channel) {
    if (channel > 0) list += ", ";
    list += spec_.channel_name(channel);
  }
  return list;
}

void RasterFile::checked(const std::function<bool()>& read) {
  std::string error;
  const bool ok = succeeds(read, &error);
  // A TIFF whose strips are missing is "read" with an error pending, and with zeros for pixels.
  const std::string pending = input_->geterror();
  if (!ok || !pending.empty()) fail(pending.empty() ? error : pending, kWholeImage);
}

void RasterFile::fill_margins(ChannelRun channels, const Sink& sink, float outside) const {
  const int columns = orientation_.stored_columns, rows = orientation_.stored_rows;
  const PixelRect& w = data_window_;
  const int top = std::clamp(w.y, 0, rows), bottom = std::clamp(w.y + w.height, top, rows);
  const int left = std::clamp(w.x, 0, columns), right = std::clamp(w.x + w.width, left, columns);
  for (const PixelRect& margin :
       {PixelRect{0, 0, columns, top}, PixelRect{0, bottom, columns, rows - bottom},
        PixelRect{0, top, left, bottom - top}, PixelRect{right, top, columns - right, bottom - top}}) {
    for (int row = 0; row < margin.height && margin.width > 0; ++row) {
      const std::vector<float> nothing(
          static_cast<std::size_t>(margin.width) * static_cast<std::size_t>(channels.count), outside);
      sink({margin.x, margin.y + row, margin.width, 1}, nothing);
    }
  }
}

void RasterFile::read(ChannelRun channels, const Sink& sink, float outside) {
  const auto turn = [&](const PixelRect& rect, std::span<const float> samples) {
    if (orientation_.is_upright()) return sink(rect, samples);
    sink(upright_rect(orientation_, rect), upright_samples(orientation_, rect, samples, channels.count));
  };
  const PixelRect whole{0, 0, orientation_.stored_columns, orientation_.stored_rows};
  const auto place = [&](const PixelRect& rect, std::span<const float> samples) {
    const PixelRect placed{rect.x + data_window_.x, rect.y + data_window_.y, rect.width, rect.height};
    const PixelRect kept = common_part(placed, whole);
    if (kept.width == placed.width && kept.height == placed.height) return turn(placed, samples);
    if (kept.width > 0 && kept.height > 0) turn(kept, cut(placed, kept, samples, channels.count));
  };
  fill_margins(channels, turn, outside);
  if (spec_.tile_width > 0) {
    read_tiles(channels, place);
  } else {
    read_scanlines(channels, place);
  }
}

void RasterFile::read_scanlines(ChannelRun channels, const Sink& sink) {
  const std::uint64_t row_samples =
      static_cast<std::uint64_t>(spec_.width) * static_cast<std::uint64_t>(channels.count);
  const int chunk_rows = static_cast<int>(std::clamp<std::uint64_t>(
      kChunkBytes / (row_samples * sizeof(float)), 1, static_cast<std::uint64_t>(spec_.height)));
  std::vector<float> samples(row_samples * static_cast<std::uint64_t>(chunk_rows));
  for (int row = 0; row < spec_.height; row += chunk_rows) {
    const int rows = std::min(chunk_rows, spec_.height - row);
    checked([&] {
      return input_->read_scanlines(0, 0, spec_.y + row, spec_.y + row + rows, spec_.z, channels.first,
                                    channels.first + channels.count, OIIO::TypeDesc::FLOAT, samples.data());
    });
    sink({0, row, spec_.width, rows},
         std::span<const float>(samples).first(row_samples * static_cast<std::uint64_t>(rows)));
  }
}

void RasterFile::read_tiles(ChannelRun channels, const Sink& sink) {
  const std::uint64_t tile_bytes = static_cast<std::uint64_t>(spec_.tile_width) *
                                   static_cast<std::uint64_t>(spec_.tile_height) *
                                   static_cast<std::uint64_t>(channels.count) * sizeof(float);
  const int chunk_columns =
      spec_.tile_width * static_cast<int>(std::clamp<std::uint64_t>(kChunkBytes / tile_bytes, 1, 1024));
  std::vector<float> samples;
  for (int row = 0; row < spec_.height; row += spec_.tile_height) {
    const int rows = std::min(spec_.tile_height, spec_.height - row);
    for (int column = 0; column < spec_.width; column += chunk_columns) {
      const int columns = std::min(chunk_columns, spec_.width - column);
      samples.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) *
                     static_cast<std::size_t>(channels.count));
      checked([&] {
        return input_->read_tiles(0, 0, spec_.x + column, spec_.x + column + columns, spec_.y + row,
                                  spec_.y + row + rows, spec_.z, spec_.z + 1, channels.first,
                                  channels.first + channels.count, OIIO::TypeDesc::FLOAT, samples.data());
      });
      sink({column, row, columns, rows}, samples);
    }
  }
}

}  // namespace prairie
