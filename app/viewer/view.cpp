#include "app/viewer/view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/scenes/installed_files.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/viewer/frame_choices.h"
#include "app/viewer/frame_times.h"
#include "app/viewer/overlay.h"
#include "app/viewer/screenshot_name.h"
#include "app/viewer/session.h"
#include "app/viewer/walker_text.h"
#include "app/viewer/window.h"
#include "files/error.h"
#include "render/frame/renderer.h"
#include "render/gl/graphics_reset.h"

namespace prairie {
namespace {

constexpr int kScreenshotSamples = 4;

/// What goes with the OpenGL context.
struct Stage {
  Stage(const World& world, glm::ivec2 size_px)
      : window(size_px), renderer(world, shader_folder()), overlay(window.handle()) {}

  Window window;
  Renderer renderer;
  Overlay overlay;
};

FrameOptions with_lines(FrameOptions options, std::span<const LineSegment> lines) {
  options.lines = lines;
  return options;
}

class Viewer {
 public:
  Viewer(World& world, const Camera& start, const ViewerOptions& options)
      : session_(world, start, options), options_(options) {
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
      const bool mouse_is_taken = session_.panels_shown && stage_->overlay.wants_mouse();
      const Steering steering = stage_->window.steering(mouse_is_taken);
      session_.move_camera(steering, passed.count(), stage_->window.framebuffer_size_px());
      for (const int key : std::exchange(keys_, {})) press(key);
      if (session_.end_wanted) stage_->window.close();
      const CartControls arrows = stage_->window.cart_controls();
      try {
        draw([&] { session_.advance(passed.count(), arrows, steering.fast); });
        if (session_.picture_wanted) take_screenshot();
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
    stage_.emplace(session_.world, size_px);
    // Later: what goes wrong with it must not be thrown through GLFW, which calls this.
    stage_->window.on_key = [this](int key) { keys_.push_back(key); };
    drawn_on_this_stage_ = false;
  }

  void rebuild(const LostContext& lost) {
    const glm::ivec2 size_px = stage_->window.size_px();
    await_end_of_reset();
    stage_.reset();
    raise_stage(size_px);
    session_.notice = "drawing goes on after " + lost.found;
    say_warning(session_.notice);
  }

  void draw(const Renderer::Meanwhile& meanwhile) {
    const ShownWalkers walkers = session_.shown_walkers();
    const FrameStatistics statistics = stage_->renderer.draw(
        session_.camera.camera(), with_lines(session_.frame_options, walkers.lines), 0, meanwhile);
    if (session_.panels_shown) show_overlay(statistics, walkers);
    stage_->window.show_frame();
  }

  std::string walkers_text(const ShownWalkers& walkers) const {
    std::string text = walkers_line(session_.world);
    if (text.empty()) return text;
    if (session_.walker_overlay != WalkerOverlay::kNone)
      text = fmt::format("{}   {}", text, walker_overlay_name(session_.walker_overlay));
    if (session_.camera.watched())
      text = fmt::format("{}\n{}", text,
                         watched_walker_line(session_.world, *session_.camera.watched(), walkers.percepts));
    return text;
  }

  std::string movement_text() const {
    if (session_.camera.mode() != CameraMode::kFree) return camera_mode_name(session_.camera.mode());
    return session_.camera.walks() ? "walking" : "flying";
  }

  void show_overlay(const FrameStatistics& statistics, const ShownWalkers& walkers) {
    OverlayText text;
    text.frame_ms = frame_times_.median_ms();
    text.statistics = statistics;
    text.camera = session_.camera.camera();
    text.movement = movement_text();
    text.tier = tier_name(session_.frame_options.tier);
    text.tinted = session_.frame_options.tier_tint;
    text.time_s = session_.world.time_s();
    text.paused = session_.play.paused();
    text.touched_blades = session_.world.motion().touched().size();
    text.steps_ms = session_.play.steps_ms();
    text.has_cart = session_.play.has_cart();
    text.field = session_.frame_options.field_overlay;
    text.walkers = walkers_text(walkers);
    text.notice = session_.notice;
    OverlaySliders sliders{session_.frame_options.quality.value(), session_.play.wind()};
    if (const int key = stage_->overlay.draw(text, sliders); key != 0) keys_.push_back(key);
    session_.frame_options.quality = sliders.quality;
    session_.play.set_wind(sliders.wind);
  }

  void press(int key) {
    session_.notice.clear();
    press_for_frames(key);
    press_for_play(key);
    press_for_wind(key);
    press_for_walkers(key);
    if (key == GLFW_KEY_ESCAPE) session_.end_wanted = true;
    if (key == GLFW_KEY_F) session_.camera.toggle_walking(session_.world.meadow().ground);
    if (key == GLFW_KEY_H) session_.panels_shown = !session_.panels_shown;
    if (key == GLFW_KEY_F12) session_.picture_wanted = true;
  }

  void press_for_frames(int key) {
    FrameOptions& options = session_.frame_options;
    if (key == GLFW_KEY_T) options.tier = next_tier(options.tier);
    if (key == GLFW_KEY_O) options.field_overlay = next_overlay(options.field_overlay);
    if (key == GLFW_KEY_G) options.tier_tint = !options.tier_tint;
    if (key == GLFW_KEY_M) options.msaa = !options.msaa;
    if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT)
      options.quality = stepped(options.quality.value(), -1);
    if (key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD)
      options.quality = stepped(options.quality.value(), +1);
  }

  void press_for_play(int key) {
    const Camera& camera = session_.camera.camera();
    if (key == GLFW_KEY_P) session_.play.toggle_pause();
    if (key == GLFW_KEY_N) session_.play.step_once();
    if (key == GLFW_KEY_B) session_.play.send_gust(camera);
    if (key == GLFW_KEY_V) session_.play.send_tornado(camera);
    if (key == GLFW_KEY_R) session_.play.roll_stone(camera);
    if (key != GLFW_KEY_C) return;
    if (session_.play.has_cart())
      session_.play.leave_cart();
    else
      session_.play.take_cart(camera);
  }

  void press_for_wind(int key) {
    WindControls wind = session_.play.wind();
    if (key == GLFW_KEY_LEFT_BRACKET) change_speed(wind, -1);
    if (key == GLFW_KEY_RIGHT_BRACKET) change_speed(wind, +1);
    if (key == GLFW_KEY_COMMA) change_heading(wind, -1);
    if (key == GLFW_KEY_PERIOD) change_heading(wind, +1);
    if (key == GLFW_KEY_SEMICOLON) change_turbulence(wind, -1);
    if (key == GLFW_KEY_APOSTROPHE) change_turbulence(wind, +1);
    session_.play.set_wind(wind);
  }

  void press_for_walkers(int key) {
    if (key == GLFW_KEY_J) session_.camera.change_mode(session_.world);
    if (key == GLFW_KEY_K) session_.watch_next_walker();
    if (key == GLFW_KEY_U) session_.notice = session_.steering.toggle(session_.camera.watched());
    if (key == GLFW_KEY_X) session_.walker_overlay = next_walker_overlay(session_.walker_overlay);
  }

  void take_screenshot() {
    session_.picture_wanted = false;
    // A full disk must not end the walk.
    try {
      const std::filesystem::path name = free_screenshot_name(std::filesystem::current_path());
      save_picture(name);
      session_.notice = "saved " + name.string();
    } catch (const OutputFailure& failure) {
      session_.notice = failure.what();
      say_fault(failure.what());
    }
  }

  void save_picture(const std::filesystem::path& name) {
    const ShownWalkers walkers = session_.shown_walkers();
    const Picture picture = stage_->renderer.render(
        session_.camera.camera(), with_lines(session_.frame_options, walkers.lines), kScreenshotSamples);
    write_output(name, encoded_picture(picture, PictureFormat::kPng));
  }

  Session session_;
  const ViewerOptions& options_;
  FrameTimes frame_times_;
  std::optional<Stage> stage_;
  bool drawn_on_this_stage_ = false;
  std::vector<int> keys_;  // pressed since the last frame
};

}  // namespace

void view_world(World& world, const Camera& start, const ViewerOptions& options) {
  Viewer(world, start, options).run();
}

}  // namespace prairie
