#include "app/view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/fly_camera.h"
#include "app/frame_keys.h"
#include "app/frame_times.h"
#include "app/installed_files.h"
#include "app/messages.h"
#include "app/option_values.h"
#include "app/outputs.h"
#include "app/overlay.h"
#include "app/picture_file.h"
#include "app/play.h"
#include "app/screenshot_name.h"
#include "app/window.h"
#include "maps/error.h"
#include "render/graphics_reset.h"
#include "render/renderer.h"

namespace prairie {
namespace {

constexpr int kScreenshotSamples = 4;
constexpr double kLongestStepS = 0.25;  // a slow frame must not throw the camera across the meadow

/// What goes with the OpenGL context.
struct Stage {
  Stage(const World& world, glm::ivec2 size_px)
      : window(size_px), renderer(world, shader_folder()), overlay(window.handle()) {}

  Window window;
  Renderer renderer;
  Overlay overlay;
};

class Viewer {
 public:
  Viewer(World& world, const Camera& start, const ViewerOptions& options)
      : world_(world), options_(options), fly_camera_(start, world.meadow().ground), play_(world, options.paused) {
    frame_options_.tier = options.tier;
    frame_options_.msaa = options.msaa;
    frame_options_.quality = world.scene().lod.quality;
    frame_options_.memory_budget_bytes = options.memory_budget_bytes;
    raise_stage(start.size_px);
  }

  void run() {
    auto last = std::chrono::steady_clock::now();
    int frames = 0;
    // Keys that were pressed before the window was closed still do what they do.
    while (frames != options_.frames && (stage_->window.poll() || !keys_.empty())) {
      const auto now = std::chrono::steady_clock::now();
      const std::chrono::duration<double> passed = now - last;
      last = now;
      if (!stage_->window.can_be_seen()) continue;
      if (frames > 0) frame_times_.add(passed.count() * 1000.0);
      const bool mouse_is_taken = overlay_shown_ && stage_->overlay.wants_mouse();
      fly_camera_.resize(stage_->window.framebuffer_size_px());
      fly_camera_.move(stage_->window.steering(mouse_is_taken), std::min(passed.count(), kLongestStepS),
                       world_.meadow().ground);
      for (const int key : std::exchange(keys_, {})) press(key);
      play_.advance(passed.count(), stage_->window.cart_controls(), fly_camera_.camera());
      try {
        draw();
        if (screenshot_wanted_) take_screenshot();
        drawn_on_this_stage_ = true;
        ++frames;
      } catch (const LostContext& lost) {
        // A picture that resets the device every time must not be tried for ever.
        if (!drawn_on_this_stage_) throw;
        rebuild(lost);
      }
    }
    if (options_.screenshot) save_picture(*options_.screenshot);
  }

 private:
  void raise_stage(glm::ivec2 size_px) {
    stage_.emplace(world_, size_px);
    // Later: what goes wrong with it must not be thrown through GLFW, which calls this.
    stage_->window.on_key = [this](int key) { keys_.push_back(key); };
    drawn_on_this_stage_ = false;
  }

  void rebuild(const LostContext& lost) {
    const glm::ivec2 size_px = stage_->window.size_px();
    await_end_of_reset();
    stage_.reset();
    raise_stage(size_px);
    notice_ = "drawing goes on after " + lost.found;
    say_warning(notice_);
  }

  void draw() {
    const FrameStatistics statistics = stage_->renderer.draw(fly_camera_.camera(), frame_options_, 0);
    if (overlay_shown_) show_overlay(statistics);
    stage_->window.show_frame();
  }

  void show_overlay(const FrameStatistics& statistics) {
    OverlayText text;
    text.frame_ms = frame_times_.median_ms();
    text.statistics = statistics;
    text.camera = fly_camera_.camera();
    text.walks = fly_camera_.walks();
    text.tier = tier_name(frame_options_.tier);
    text.tinted = frame_options_.tier_tint;
    text.time_s = world_.time_s();
    text.paused = play_.paused();
    text.touched_blades = world_.motion().touched().size();
    text.steps_ms = play_.steps_ms();
    text.has_cart = play_.has_cart();
    text.field = frame_options_.field_overlay;
    text.notice = notice_;
    OverlaySliders sliders{frame_options_.quality.value(), play_.wind()};
    if (const int key = stage_->overlay.draw(text, sliders); key != 0) keys_.push_back(key);
    frame_options_.quality = sliders.quality;
    play_.set_wind(sliders.wind);
  }

  void press(int key) {
    notice_.clear();
    apply_frame_key(key, frame_options_);
    play_.press(key, fly_camera_.camera());
    if (key == GLFW_KEY_ESCAPE) stage_->window.close();
    if (key == GLFW_KEY_F) fly_camera_.toggle_walking(world_.meadow().ground);
    if (key == GLFW_KEY_H) overlay_shown_ = !overlay_shown_;
    if (key == GLFW_KEY_F12) screenshot_wanted_ = true;
  }

  void take_screenshot() {
    screenshot_wanted_ = false;
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
    const Picture picture = stage_->renderer.render(fly_camera_.camera(), frame_options_, kScreenshotSamples);
    write_output(name, encoded_picture(picture, PictureFormat::kPng));
  }

  World& world_;
  const ViewerOptions& options_;
  FlyCamera fly_camera_;
  Play play_;
  FrameOptions frame_options_;
  FrameTimes frame_times_;
  std::optional<Stage> stage_;
  bool drawn_on_this_stage_ = false;
  bool overlay_shown_ = true;
  bool screenshot_wanted_ = false;
  std::vector<int> keys_;  // pressed since the last frame
  std::string notice_;
};

}  // namespace

void view_world(World& world, const Camera& start, const ViewerOptions& options) {
  Viewer(world, start, options).run();
}

}  // namespace prairie
