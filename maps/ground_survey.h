// One pass over a height map that does not fit into memory: what a height field must know of the whole before
// it can answer questions about any part.
#pragma once

#include "maps/filled_heights.h"
#include "maps/height_bounds.h"
#include "maps/height_range.h"
#include "maps/node_grid.h"

namespace prairie {

struct GroundSurvey {
  HeightRange measured_m;
  bool has_gaps = false;
  HeightBounds bounds;      // of measured and filled nodes
  GroundOverview overview;  // filled
};

/// Reads the whole grid, strip by strip. Throws BadInput if no node has data or the nodes cannot be read.
GroundSurvey survey_ground(const NodeGrid& measured_m);

}  // namespace prairie
