// A georeferenced raster's values, as far as they are not yet a map's.
#pragma once

#include "maps/georaster/georaster.h"
#include "maps/map_file.h"
#include "maps/stored_raster.h"

namespace prairie {

class StoredGeoraster : public StoredRaster {
 public:
  /// Throws BadInput where a unit of heights is none of length.
  StoredGeoraster(const Georaster& raster, const MapSpec& spec, MapMeaning meaning);

  int columns() const override { return raster_.columns(); }
  int rows() const override { return raster_.rows(); }
  void read(ChannelRun channels, const Sink& sink) override;
  /// The values of a rectangle, channels interleaved.
  std::vector<double> read_window(const PixelRect& rect, ChannelRun channels) const;

 private:
  const Georaster& raster_;
  bool is_palette_ = false;  // of one band, which becomes R, G, B
};

}  // namespace prairie
