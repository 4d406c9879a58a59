// What is known of a walker as it is drawn (render/things/walker_pass.h).
#pragma once

#include <cstdint>

#include "agents/walker_pose.h"

namespace prairie {

struct WalkerLook {
  double height_m = 1.75;
  std::uint32_t seed = 0;  // of its colours
  WalkerPose pose{};
};

}  // namespace prairie
