// One pass over a height map that does not fit into memory: what a height field must know of it before it can
// answer questions about any part of it, and the nodes of its gaps, filled window by window.
#pragma once

#include "maps/error.h"
#include "maps/height_bounds.h"
#include "maps/nodata_fill.h"
#include "maps/node_grid.h"

namespace prairie {

struct GroundSurvey {
  HeightRange measured_m;
  bool has_gaps = false;
  HeightBounds bounds;  // of measured and filled nodes
  FillLevel overview;   // filled; cells of 2^overview_level nodes
  int overview_level = 0;
};

/// Reads the whole grid, strip by strip. Throws BadInput if no node has data or the nodes cannot be read.
GroundSurvey survey_ground(const NodeGrid& measured_m);

/// The grid without its gaps: as `fill_nodata` would fill the whole of it.
NodeGrid fill_from_survey(const NodeGrid& measured_m, FillLevel overview, int overview_level);

/// The fault of a height map without a single measured node.
BadInput no_ground();

}  // namespace prairie
