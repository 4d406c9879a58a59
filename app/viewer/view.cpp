#include "app/viewer/view.h"

#include "app/viewer/actions.h"
#include "app/viewer/frame_loop.h"
#include "app/viewer/panels.h"
#include "app/viewer/session.h"

namespace prairie {

void view_world(World& world, const Camera& start, const ViewerOptions& options) {
  Session session(world, start, options);
  FrameLoop(session, {viewer_actions(), viewer_panels()}, options).run();
}

}  // namespace prairie
