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
  const double in_clip_s = clip_.format().frame_rate.time_s(frame);
  Camera camera = placed_camera(view_.path ? camera_at(*view_.path, in_clip_s) : view_.standing, world_,
                                clip_.format().size_px);
  camera.orthographic_height_m = view_.parallel_height_m.value_or(0.0);
  return camera;
}

void Recording::add(int frame, const Renderer::Meanwhile& meanwhile) {
  clip_.add(renderer_.render(camera(frame), look_, view_.samples, meanwhile));
}

}  // namespace prairie
