// What `prairie info` prints: the report on a scene as text for people, or as JSON for programs.
#pragma once

#include <string>

#include "app/scenes/info.h"

namespace prairie {

/// Lines.
std::string info_text(const SceneReport& report);

/// One object.
std::string info_json(const SceneReport& report);

}  // namespace prairie
