// Options of commands that open a window, for tests and for whoever wants a picture of what it shows; help is
// silent about them. What they set must live as long as the command.
#pragma once

#include "app/commands/command.h"
#include "app/viewer/view.h"

namespace prairie {

/// `--frames`: after so many the window closes.
CommandOption window_frames_option(ViewerOptions& viewer);
/// `--screenshot`: the last picture is saved there.
CommandOption window_screenshot_option(ViewerOptions& viewer);

}  // namespace prairie
