// What the graphics device takes for a stage of the frame (measured by render/gl/gpu_timeline.h).
#pragma once

namespace prairie {

struct StageTime {
  const char* name = "";
  double ms = 0.0;  // of the latest frame that is known
};

}  // namespace prairie
