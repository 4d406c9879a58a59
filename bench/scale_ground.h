// The square kilometre that `scale` walks over: a public lidar tile of treeless prairie where PRAIRIE_DATA
// names the folder that holds it, else made-up ground of the same relief.
#pragma once

#include <filesystem>
#include <string>

#include "maps/node_grid.h"

namespace prairie {

struct ScaleGround {
  std::filesystem::path file;  // heights in metres, 1 m from node to node
  std::string name;            // for the reader of the measurements
};

/// The made-up ground lies in `folder`; it is written there if it is not there yet. Throws OutputFailure.
ScaleGround scale_ground(const std::filesystem::path& folder);

/// The heights of the made-up ground, 1001 × 1001 nodes.
NodeGrid made_up_prairie();

/// What ground is like to walk on.
struct Relief {
  double deviation_m = 0.0;       // standard deviation of the heights
  double median_slope_deg = 0.0;  // of the steepest slope, by central differences
  double steep_slope_deg = 0.0;   // its 99th percentile
  double correlation_m = 0.0;     // distance at which the heights' autocorrelation falls to 1/e
};

/// Of a grid of heights in memory, without gaps.
Relief relief_of(const NodeGrid& heights_m);

}  // namespace prairie
