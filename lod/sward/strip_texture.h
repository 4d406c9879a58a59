// The strips' texture (G03 §3.4): for each species and each side from which a strip is seen, the program's
// own blades drawn from the side, each with its rank in alpha, so that an alpha test shows the first so many.
// Colours are stored as shares of their row's mean; strips are painted in the mean that 3D blades would show.
#pragma once

#include <cstdint>
#include <vector>

namespace prairie {

inline constexpr int kStripColumns = 512;  // texels along a tile's side; closes on itself
inline constexpr int kStripRows = 64;      // from the foot to the longest blade's length
inline constexpr int kStripFacings = 4;    // seen from the south, east, north, west

/// One layer's finest level as it was drawn: radiance and rank; rank 1 where there is no blade.
struct StripDrawing {
  int columns = 0;
  int rows = 0;
  std::vector<float> rgba;  // rows from the foot
};

struct StripLevel {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> rgba;  // rgb: radiance over its row's mean / kBrightest; a: rank, 255 = none
};

/// Share of the rows, from the foot, above which there is hardly a blade.
float standing_share(const StripDrawing& drawing);

/// All levels of a layer, finest first. A coarse texel takes the rank of one of its four, so that at every
/// threshold equally many texels are shown on all levels, and the mean of their colours.
std::vector<StripLevel> strip_levels(const StripDrawing& drawing);

}  // namespace prairie
