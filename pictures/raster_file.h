// An image file opened without trusting it: its claims are checked against limits, against each other and
// against the size of the file before memory is spent, and every read is checked. What is stored turned or
// mirrored is turned upright; an EXR whose pixels fill a part of its picture lies where they belong.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pictures/pixel_rect.h"
#include "pictures/upright.h"

namespace prairie {

/// How a channel's samples are stored.
struct SampleType {
  int bits = 32;
  double largest = 0.0;  // of an integer type; 0 for a floating-point one

  bool is_integer() const { return largest > 0.0; }
};

/// Neighbouring channels of a file.
struct ChannelRun {
  int first = 0;
  int count = 0;
};

class RasterFile {
 public:
  /// `file_bytes`: the size of the file. Throws BadInput (for `field`) where the file is no image, or one
  /// larger than the limits, or one that claims more pixels than its bytes can hold.
  RasterFile(const std::filesystem::path& path, const std::string& field, std::uint64_t file_bytes);
  ~RasterFile();

  int columns() const { return orientation_.columns(); }
  int rows() const { return orientation_.rows(); }
  const OIIO::ImageSpec& spec() const { return spec_; }
  SampleType sample_type(int channel) const;
  /// "R, G, B, A"
  std::string channel_list() const;

  /// Takes samples of `rect`, row by row from the top, channels interleaved; integers as v / largest, NaN
  /// where the file has no pixels.
  using Sink = std::function<void(const PixelRect& rect, std::span<const float> samples)>;
  /// Hands every pixel to `sink` once, in the file's own order; where the picture reaches beyond the pixels
  /// that are stored, `outside`. Throws BadInput where the file breaks off.
  void read(ChannelRun channels, const Sink& sink, float outside = 0.0f);

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;
  void check_claims(std::uint64_t file_bytes) const;
  void look_at_layout();
  /// Runs one read; throws BadInput unless it succeeds without a word of complaint.
  void checked(const std::function<bool()>& read);
  void read_scanlines(ChannelRun channels, const Sink& sink);
  void read_tiles(ChannelRun channels, const Sink& sink);
  /// Hands out the part of the picture that has no pixels.
  void fill_margins(ChannelRun channels, const Sink& sink, float outside) const;

  std::filesystem::path path_;
  std::string field_;
  OIIO::ImageSpec spec_;
  PixelRect data_window_;  // in the whole picture, as it is stored
  Orientation orientation_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace prairie
