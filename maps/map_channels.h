// Which of a file's channels a map is made of.
#pragma once

#include <span>

#include "files/error.h"
#include "maps/map_file.h"
#include "maps/stored_raster.h"

namespace prairie {

struct MapChannels {
  ChannelRun run;           // what is read
  bool must_equal = false;  // the run is a grey value three times, and perhaps an opaque alpha after it
  bool has_alpha = false;   // the last of an equal run is alpha
};

/// Throws BadInput, listing the file's channels, where the file does not say by itself and `spec` does not
/// either.
MapChannels choose_channels(const StoredRaster& raster, const MapSpec& spec, MapMeaning meaning);

/// The fault of a file whose channels differ although nobody said which one is meant.
BadInput ambiguous_channels(const StoredRaster& raster, const MapSpec& spec);

/// Whether every pixel is grey and opaque (alpha = its type's largest, or 1).
bool all_grey(const MapChannels& channels, double opaque, std::span<const double> values);

}  // namespace prairie
