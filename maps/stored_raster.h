// A raster as its file stores it: columns, rows, channels and their values, before anybody says what they
// mean.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pictures/pixel_rect.h"
#include "pictures/raster_file.h"

namespace prairie {

/// What the values v of a channel are: quantities scale · v + offset of a unit.
struct StoredChannel {
  std::string name;
  SampleType type;
  std::optional<double> nodata = std::nullopt;
  bool has_scale = false;
  double scale = 1.0;
  double offset = 0.0;
  double metres_per_unit = 1.0;  // where the quantity is a height
  bool is_measured = false;      // integers are the quantity itself, not shares of a range
};

class StoredRaster {
 public:
  virtual ~StoredRaster() = default;

  virtual int columns() const = 0;
  virtual int rows() const = 0;
  const std::vector<StoredChannel>& channels() const { return channels_; }
  /// Of a channel that veils the others; none where alpha is a mask, which is obeyed.
  std::optional<int> alpha_channel() const { return alpha_channel_; }
  /// "R, G, B, A"
  std::string channel_list() const;

  /// Takes values of `rect`, row by row from the top, channels interleaved, as they are stored; NaN = none.
  using Sink = std::function<void(const PixelRect& rect, std::span<const double> values)>;
  /// Hands every pixel to `sink` once, in the file's own order. Throws BadInput where the file breaks off.
  virtual void read(ChannelRun channels, const Sink& sink) = 0;

 protected:
  std::vector<StoredChannel> channels_;
  std::optional<int> alpha_channel_;
};

}  // namespace prairie
