// All that a person can do in the viewer, told once.
#pragma once

#include <vector>

#include "app/viewer/action.h"

namespace prairie {

std::vector<Action> viewer_actions();

}  // namespace prairie
