// What the viewer's panels say.
#pragma once

#include <string>
#include <vector>

#include "app/viewer/panel.h"
#include "app/viewer/session.h"

namespace prairie {

/// How long frames take, what they draw, and with which tiers.
std::vector<std::string> statistics_lines(const Session& session, const DrawnFrame& frame);

/// How the camera moves, and where it is in the form that --camera takes.
std::string camera_line(const Session& session);

std::string time_line(const Session& session);

/// Nothing where nobody walks.
std::vector<std::string> walker_lines(const Session& session, const DrawnFrame& frame);

/// Nothing where no field is shown.
std::string field_line(const Session& session);

}  // namespace prairie
