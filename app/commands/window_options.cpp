#include "app/commands/window_options.h"

namespace prairie {

CommandOption window_frames_option(ViewerOptions& viewer) {
  constexpr int kMostFrames = 1'000'000;
  return {.names = "--frames",
          .type = "TEXT",
          .help = "Close after so many frames",
          .target = whole_number_into(viewer.frames, 1, kMostFrames),
          .is_hidden = true};
}

CommandOption window_screenshot_option(ViewerOptions& viewer) {
  return {.names = "--screenshot",
          .type = "TEXT",
          .help = "Save the last picture",
          .target = text_into(viewer.screenshot),
          .is_hidden = true};
}

}  // namespace prairie
