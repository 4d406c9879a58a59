// The viewer's panels, one below the other in the corner of the window: what frames take and draw, the
// camera, time, walkers, sliders for quality and wind, buttons and what keys do.
#pragma once

#include <vector>

#include "app/viewer/panel.h"

namespace prairie {

std::vector<PanelWindow> viewer_panels();

}  // namespace prairie
