#include "maps/stored_images.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "files/error.h"
#include "files/input_file.h"

namespace prairie {
namespace {

constexpr double kRawLargest = 65535.0;
constexpr int kRawBytes = 2;

class StoredImage : public StoredRaster {
 public:
  StoredImage(const MapSpec& spec, std::uint64_t file_bytes) : file_(spec.file, spec.field, file_bytes) {
    const OIIO::ImageSpec& image = file_.spec();
    for (int k = 0; k < image.nchannels; ++k)
      channels_.push_back({.name = image.channel_name(k), .type = file_.sample_type(k)});
    // Alpha comes last wherever a format has one.
    if (image.alpha_channel >= 0 && image.alpha_channel == image.nchannels - 1)
      alpha_channel_ = image.alpha_channel;
  }

  int columns() const override { return file_.columns(); }
  int rows() const override { return file_.rows(); }

  void read(ChannelRun channels, const Sink& sink) override {
    std::vector<double> values;
    file_.read(
        channels,
        [&](const PixelRect& rect, std::span<const float> samples) {
          values.resize(samples.size());
          for (std::size_t k = 0; k < samples.size(); ++k) {
            const std::size_t channel =
                static_cast<std::size_t>(channels.first) + k % static_cast<std::size_t>(channels.count);
            values[k] = stored_value(channels_[channel].type, samples[k]);
          }
          sink(rect, values);
        },
        std::numeric_limits<float>::quiet_NaN());
  }

 private:
  static double stored_value(SampleType type, float sample) {
    if (!type.is_integer()) return static_cast<double>(sample);
    const double value = static_cast<double>(sample) * type.largest;
    // A float holds every quotient of 16 bits exactly enough to get the integer back; of 32 bits it does not.
    return type.bits <= 16 ? std::nearbyint(value) : value;
  }

  RasterFile file_;
};

class RawHeights : public StoredRaster {
 public:
  explicit RawHeights(const MapSpec& spec)
      : columns_((*spec.size_px)[0]),
        rows_((*spec.size_px)[1]),
        bytes_(read_input(spec.file, spec.field, wanted_bytes())) {
    if (bytes_.size() != wanted_bytes()) {
      throw BadInput(spec.file.string(), spec.field, fmt::format("{} bytes", bytes_.size()),
                     fmt::format("{}: {} × {} integers of 16 bits", wanted_bytes(), columns_, rows_));
    }
    channels_.push_back({.name = "Y", .type = {16, kRawLargest}});
  }

  int columns() const override { return columns_; }
  int rows() const override { return rows_; }

  void read(ChannelRun, const Sink& sink) override {
    const auto width = static_cast<std::size_t>(columns_);
    std::vector<double> values(width);
    for (int row = 0; row < rows_; ++row) {
      const std::byte* from = bytes_.data() + static_cast<std::size_t>(row) * width * kRawBytes;
      for (std::size_t k = 0; k < width; ++k)
        values[k] = std::to_integer<int>(from[2 * k]) + 256 * std::to_integer<int>(from[2 * k + 1]);
      sink({0, row, columns_, 1}, values);
    }
  }

 private:
  std::uint64_t wanted_bytes() const {
    return std::uint64_t{kRawBytes} * static_cast<std::uint64_t>(columns_) *
           static_cast<std::uint64_t>(rows_);
  }

  int columns_;
  int rows_;
  std::vector<std::byte> bytes_;
};

}  // namespace

std::string StoredRaster::channel_list() const {
  std::string list;
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    if (k > 0) list += ", ";
    list += channels_[k].name.empty() ? fmt::format("{}", k + 1) : channels_[k].name;
  }
  return list;
}

bool has_raw_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".r16" || extension == ".raw";
}

std::unique_ptr<StoredRaster> open_image(const MapSpec& spec, std::uint64_t file_bytes) {
  if (spec.size_px) return std::make_unique<RawHeights>(spec);
  if (has_raw_name(spec.file)) {
    const double side = std::sqrt(static_cast<double>(file_bytes) / kRawBytes);
    const double whole = std::nearbyint(side);
    const std::string example = whole * whole * kRawBytes == static_cast<double>(file_bytes)
                                    ? fmt::format("[{0:.0f}, {0:.0f}]", whole)
                                    : "[513, 513]";
    throw BadInput(spec.file.string(), spec.field,
                   fmt::format("a raw file of {} bytes, which does not tell its size", file_bytes),
                   fmt::format("`size_px`, its columns and rows of 16-bit integers, such as {}", example));
  }
  return std::make_unique<StoredImage>(spec, file_bytes);
}

}  // namespace prairie
