// Panels over the picture, as tables that follow one another: the viewer's (app/viewer/panels.h), and
// whatever another folder adds.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "agents/behaviour.h"
#include "app/viewer/action.h"
#include "app/viewer/session.h"
#include "render/frame/frame_options.h"

namespace prairie {

/// What panels tell besides the session.
struct DrawnFrame {
  double median_ms = 0.0;  // that frames took lately
  FrameStatistics statistics;
  std::span<const Percept> percepts;  // as ShownWalkers has them
};

/// What a panel draws from, and takes orders for.
struct PanelInput {
  Session& session;  // sliders change it
  std::span<const Action> actions;
  const DrawnFrame& frame;
  std::vector<std::string>& chosen;  // names of the actions whose buttons were pressed
};

/// Draws with Dear ImGui, from the cursor of its window downwards.
using Panel = std::function<void(PanelInput&)>;

struct PanelWindow {
  std::string title;          // not shown; another one for each window
  glm::vec2 corner{0.0f};     // in which it lies: x from the left, y from the top, 0 or 1
  std::vector<Panel> panels;  // one below the other
};

}  // namespace prairie
