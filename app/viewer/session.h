// A world at a window with all that a person's actions change: its time and what is put into it, the camera,
// whom the arrow keys steer, what is shown. Knows neither windows, keys nor OpenGL.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "agents/behaviour.h"
#include "agents/driven_cart.h"
#include "app/viewer/play.h"
#include "app/viewer/viewer_options.h"
#include "app/viewer/walker_camera.h"
#include "app/viewer/walker_overlay.h"
#include "app/viewer/walker_steering.h"
#include "app/viewer/walker_trails.h"
#include "lod/camera.h"
#include "render/frame/frame_options.h"
#include "render/overlays/line_segment.h"

namespace prairie {

class World;

/// What a frame shows and tells of the walkers.
struct ShownWalkers {
  std::vector<Percept> percepts;  // of all; empty where nothing shows or tells any
  std::vector<LineSegment> lines;
};

struct Session {
  /// The world must outlive it.
  Session(World& world, const Camera& start, const ViewerOptions& options);

  /// Has the camera go on for a frame, in a window of that size.
  void move_camera(const Steering& steering, double passed_s, glm::ivec2 size_px);
  /// Has the world go on for a frame. The arrow keys are the steered walker's, the cart's while there is
  /// none; `fast`: shift is held.
  void advance(double passed_s, const CartControls& arrows, bool fast);
  ShownWalkers shown_walkers() const;

  bool has_walkers() const;
  /// Watches the next walker; whoever was steered decides for itself again.
  void watch_next_walker();

  World& world;
  WalkerCamera camera;
  WalkerSteering steering;
  WalkerTrails trails;
  Play play;
  FrameOptions frame_options;  // without lines
  WalkerOverlay walker_overlay = WalkerOverlay::kNone;
  bool panels_shown = true;
  std::string notice;           // what the last action has to tell
  bool picture_wanted = false;  // of what is seen now, as a file
  bool end_wanted = false;
};

}  // namespace prairie
