// Nodes of a raster that stays on disk: tiles come and go in a cache of OpenImageIO's of bounded size.
#pragma once

#include <cstdint>
#include <memory>

#include "maps/map_file.h"
#include "maps/value_mapping.h"
#include "pictures/raster_file.h"

namespace prairie {

/// What of a file, which RasterFile has checked, becomes nodes.
struct CachedRasterSpec {
  MapSpec map;
  OIIO::ImageSpec image;
  ChannelRun channels;  // of the file
  int value_channels = 1;
};

/// Reading throws BadInput if the file has changed or vanished meanwhile.
std::shared_ptr<const NodeSource> make_cached_raster(const CachedRasterSpec& spec,
                                                     const ValueMapping& mapping, std::uint64_t budget_bytes);

}  // namespace prairie
