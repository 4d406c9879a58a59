#include "app/outputs/recording.h"

#include "app/scenes/camera_option.h"
#include "app/scenes/installed_files.h"

namespace prairie {

Recording::Recording(Clip& clip, const ClipView& view, const GlobalOptions& globals, const World& world)
    : clip_(clip), view_(view), world_(world), context_(globals.device), renderer_(world, shader_folder()) {
  look_.tier = view.tier;
  look_.memory_budget_bytes = globals.max_memory_bytes;
  clip_.begin();
}

Camera Recording::camera(int frame) const {
  const double in_clip_s = static_cast<double>(frame) / clip_.format().frames_per_s;
  return placed_camera(view_.path ? camera_at(*view_.path, in_clip_s) : view_.standing, world_,
                       clip_.format().size_px);
}

void Recording::add(int frame, const Renderer::Meanwhile& meanwhile) {
  clip_.add(renderer_.render(camera(frame), look_, view_.samples, meanwhile));
}

}  // namespace prairie
