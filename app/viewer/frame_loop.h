// A session at a window, frame after frame: handles what happens in it, draws, and goes on after a reset of
// the graphics device.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "agents/driven_cart.h"
#include "app/viewer/action.h"
#include "app/viewer/frame_times.h"
#include "app/viewer/key.h"
#include "app/viewer/panel.h"
#include "app/viewer/session.h"
#include "app/viewer/stage.h"
#include "app/viewer/viewer_options.h"
#include "files/error.h"

namespace prairie {

/// What a person finds in the window. Other folders add theirs to the viewer's.
struct WindowContents {
  std::vector<Action> actions;  // of those that one key stands for, the first one available is done
  std::vector<PanelWindow> windows;
};

class FrameLoop {
 public:
  /// Opens the window. The session must outlive it. Throws as run().
  FrameLoop(Session& session, WindowContents contents, const ViewerOptions& options);

  /// Until the window is closed, or as many frames were drawn as the options say. Throws NoSuitableOpenGl,
  /// OverBudget; LostContext if the first frame in a new window is lost, too.
  void run();

 private:
  void raise_stage(glm::ivec2 size_px);
  void rebuild(const LostContext& lost);
  bool is_asked() const { return !chosen_.empty() || !keys_.empty(); }
  void act();
  void show_frame(double passed_s);
  void draw(double passed_s, const CartControls& arrows, bool fast);
  void draw_panels(FrameStatistics statistics, const ShownWalkers& walkers);
  void take_screenshot();
  void save_picture(const std::filesystem::path& name);

  Session& session_;
  WindowContents contents_;
  const ViewerOptions options_;
  FrameTimes frame_times_;
  std::optional<Stage> stage_;
  bool drawn_on_this_stage_ = false;
  std::vector<std::string> chosen_;  // actions whose buttons were pressed in the last frame
  std::vector<Key> keys_;            // pressed since
};

}  // namespace prairie
