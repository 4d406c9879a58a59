// What `prairie info` prints: the report on a scene as text for people, or as JSON for programs.
#pragma once

#include <iosfwd>

#include "app/scenes/info.h"

namespace prairie {

void print_text(const SceneReport& report, std::ostream& out);

/// One object.
void print_json(const SceneReport& report, std::ostream& out);

}  // namespace prairie
