#include "app/view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>

#include "app/fly_camera.h"
#include "app/frame_times.h"
#include "app/installed_files.h"
#include "app/messages.h"
#include "app/option_values.h"
#include "app/outputs.h"
#include "app/overlay.h"
#include "app/picture_file.h"
#include "app/screenshot_name.h"
#include "app/window.h"
#include "maps/error.h"
#include "render/renderer.h"

namespace prairie {
namespace {

constexpr int kScreenshotSamples = 4;
constexpr double kLongestStepS = 0.25;  // a slow frame must not throw the camera across the meadow

Tier next_tier(Tier tier) {
  switch (tier) {
    case Tier::kAuto:
      return Tier::kSpline;
    case Tier::kSpline:
      return Tier::kHermite;
    case Tier::kHermite:
      return Tier::kStrip;
    case Tier::kStrip:
      return Tier::kFlat;
    case Tier::kFlat:
      break;
  }
  return Tier::kAuto;
}

class Viewer {
 public:
  Viewer(const World& world, const Camera& start, const ViewerOptions& options)
      : world_(world),
        options_(options),
        window_(start.size_px),
        renderer_(world, shader_folder()),
        overlay_(window_.handle()),
        fly_camera_(start, world.meadow().ground) {
    frame_options_.tier = options.tier;
    frame_options_.msaa = options.msaa;
    frame_options_.memory_budget_bytes = options.memory_budget_bytes;
    window_.on_key = [this](int key) { press(key); };
  }

  void run() {
    auto last = std::chrono::steady_clock::now();
    for (int frame = 1; window_.poll(); ++frame) {
      const auto now = std::chrono::steady_clock::now();
      const std::chrono::duration<double> passed = now - last;
      last = now;
      if (frame > 1) frame_times_.add(passed.count() * 1000.0);
      fly_camera_.resize(window_.framebuffer_size_px());
      fly_camera_.move(window_.steering(), std::min(passed.count(), kLongestStepS), world_.meadow().ground);
      draw();
      if (frame == options_.frames) break;
    }
    if (options_.screenshot) save_picture(*options_.screenshot);
  }

 private:
  void draw() {
    const FrameStatistics statistics = renderer_.draw(fly_camera_.camera(), frame_options_, 0);
    if (overlay_shown_) {
      OverlayText text;
      text.frame_ms = frame_times_.median_ms();
      text.blades_drawn = statistics.blades_drawn;
      text.triangles = statistics.triangles;
      text.camera = fly_camera_.camera();
      text.walks = fly_camera_.walks();
      text.tier = tier_name(frame_options_.tier);
      text.notice = notice_;
      overlay_.draw(text);
    }
    window_.show_frame();
  }

  void press(int key) {
    notice_.clear();
    if (key == GLFW_KEY_ESCAPE) window_.close();
    if (key == GLFW_KEY_F) fly_camera_.toggle_walking(world_.meadow().ground);
    if (key == GLFW_KEY_T) frame_options_.tier = next_tier(frame_options_.tier);
    if (key == GLFW_KEY_M) frame_options_.msaa = !frame_options_.msaa;
    if (key == GLFW_KEY_H) overlay_shown_ = !overlay_shown_;
    if (key == GLFW_KEY_F12) take_screenshot();
  }

  void take_screenshot() {
    // A full disk must not end the walk.
    try {
      const std::filesystem::path name = free_screenshot_name(std::filesystem::current_path());
      save_picture(name);
      notice_ = "saved " + name.string();
    } catch (const OutputFailure& failure) {
      notice_ = failure.what();
      say_fault(failure.what());
    }
  }

  void save_picture(const std::filesystem::path& name) {
    const Picture picture = renderer_.render(fly_camera_.camera(), frame_options_, kScreenshotSamples);
    write_output(name, encoded_picture(picture, PictureFormat::kPng));
  }

  const World& world_;
  const ViewerOptions& options_;
  Window window_;
  Renderer renderer_;
  Overlay overlay_;
  FlyCamera fly_camera_;
  FrameOptions frame_options_;
  FrameTimes frame_times_;
  bool overlay_shown_ = true;
  std::string notice_;
};

}  // namespace

void view_world(const World& world, const Camera& start, const ViewerOptions& options) {
  Viewer(world, start, options).run();
}

}  // namespace prairie
