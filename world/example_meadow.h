// The meadow that `prairie new` makes up: a shallow valley with a path that winds through it and a mown
// clearing, a low fescue nearly everywhere and a taller golden grass in drifts. Everything follows from the
// seed.
#pragma once

#include <cstdint>
#include <vector>

#include "maps/node_grid.h"
#include "world/scene/scene.h"

namespace prairie {

/// An 8-bit map, rows from the top (= north), 0 … 255 standing for 0 … max.
struct GreyMap {
  int columns = 0;
  int rows = 0;
  double spacing_m = 1.0;
  double max = 1.0;
  std::vector<std::uint8_t> values;
};

struct ExampleMeadow {
  NodeGrid ground_m;
  GreyMap fescue_per_m2;
  GreyMap oatgrass_per_m2;
  GreyMap blade_height;             // factor: short beside the path and around the clearing
  std::vector<CameraSpec> cameras;  // the first is "default"
};

ExampleMeadow make_example_meadow(std::uint64_t seed);

}  // namespace prairie
