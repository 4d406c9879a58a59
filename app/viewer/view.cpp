#include "app/viewer/view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
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
#include "app/viewer/play.h"
#include "app/viewer/screenshot_name.h"
#include "app/viewer/walker_camera.h"
#include "app/viewer/walker_overlay.h"
#include "app/viewer/walker_steering.h"
#include "app/viewer/walker_text.h"
#include "app/viewer/walker_trails.h"
#include "app/viewer/window.h"
#include "files/error.h"
#include "render/frame/renderer.h"
#include "render/gl/graphics_reset.h"

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
      : world_(world),
        options_(options),
        camera_(start, world, options.follow),
        steering_(world),
        play_(world, options.paused) {
    play_.look(camera_.camera());
    if (options.walker_overlay) walker_overlay_ = WalkerOverlay::kBoth;
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
      const Steering steering = stage_->window.steering(mouse_is_taken);
      camera_.resize(stage_->window.framebuffer_size_px());
      camera_.move(steering, std::min(passed.count(), kLongestStepS), world_);
      for (const int key : std::exchange(keys_, {})) press(key);
      const CartControls arrows = stage_->window.cart_controls();
      try {
        draw([&] { advance(passed.count(), arrows, steering.fast); });
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

  /// The arrow keys are the steered walker's, the cart's while there is none. Runs while a frame is drawn.
  void advance(double passed_s, const CartControls& arrows, bool fast) {
    steering_.steer({arrows.drive, arrows.steer, fast});
    play_.advance(passed_s, steering_.steered() ? CartControls{} : arrows, camera_.camera());
    trails_.follow(world_, camera_.camera().eye_m);
  }

  void draw(const Renderer::Meanwhile& meanwhile) {
    perceive();
    const FrameStatistics statistics = stage_->renderer.draw(camera_.camera(), frame_options_, 0, meanwhile);
    if (overlay_shown_) show_overlay(statistics);
    stage_->window.show_frame();
  }

  /// What this frame shows of the walkers.
  void perceive() {
    const glm::dvec3 eye_m = camera_.camera().eye_m;
    const bool told = overlay_shown_ && camera_.watched();
    percepts_.clear();
    lines_.clear();
    if (told || shows_sensors(walker_overlay_)) percepts_ = world_.percepts();
    if (shows_paths(walker_overlay_)) lines_ = path_lines(world_, trails_, eye_m);
    if (shows_sensors(walker_overlay_)) {
      const std::vector<LineSegment> sensors = sensor_lines(world_, percepts_, eye_m);
      lines_.insert(lines_.end(), sensors.begin(), sensors.end());
    }
    frame_options_.lines = lines_;
  }

  std::string walkers_text() const {
    std::string text = walkers_line(world_);
    if (text.empty()) return text;
    if (walker_overlay_ != WalkerOverlay::kNone)
      text = fmt::format("{}   {}", text, walker_overlay_name(walker_overlay_));
    if (camera_.watched())
      text = fmt::format("{}\n{}", text, watched_walker_line(world_, *camera_.watched(), percepts_));
    return text;
  }

  std::string movement_text() const {
    if (camera_.mode() != CameraMode::kFree) return camera_mode_name(camera_.mode());
    return camera_.walks() ? "walking" : "flying";
  }

  void show_overlay(const FrameStatistics& statistics) {
    OverlayText text;
    text.frame_ms = frame_times_.median_ms();
    text.statistics = statistics;
    text.camera = camera_.camera();
    text.movement = movement_text();
    text.tier = tier_name(frame_options_.tier);
    text.tinted = frame_options_.tier_tint;
    text.time_s = world_.time_s();
    text.paused = play_.paused();
    text.touched_blades = world_.motion().touched().size();
    text.steps_ms = play_.steps_ms();
    text.has_cart = play_.has_cart();
    text.field = frame_options_.field_overlay;
    text.walkers = walkers_text();
    text.notice = notice_;
    OverlaySliders sliders{frame_options_.quality.value(), play_.wind()};
    if (const int key = stage_->overlay.draw(text, sliders); key != 0) keys_.push_back(key);
    frame_options_.quality = sliders.quality;
    play_.set_wind(sliders.wind);
  }

  void press(int key) {
    notice_.clear();
    press_for_frames(key);
    press_for_play(key);
    press_for_wind(key);
    press_for_walkers(key);
    if (key == GLFW_KEY_ESCAPE) stage_->window.close();
    if (key == GLFW_KEY_F) camera_.toggle_walking(world_.meadow().ground);
    if (key == GLFW_KEY_H) overlay_shown_ = !overlay_shown_;
    if (key == GLFW_KEY_F12) screenshot_wanted_ = true;
  }

  void press_for_frames(int key) {
    FrameOptions& options = frame_options_;
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
    const Camera& camera = camera_.camera();
    if (key == GLFW_KEY_P) play_.toggle_pause();
    if (key == GLFW_KEY_N) play_.step_once();
    if (key == GLFW_KEY_B) play_.send_gust(camera);
    if (key == GLFW_KEY_V) play_.send_tornado(camera);
    if (key == GLFW_KEY_R) play_.roll_stone(camera);
    if (key != GLFW_KEY_C) return;
    if (play_.has_cart())
      play_.leave_cart();
    else
      play_.take_cart(camera);
  }

  void press_for_wind(int key) {
    WindControls wind = play_.wind();
    if (key == GLFW_KEY_LEFT_BRACKET) change_speed(wind, -1);
    if (key == GLFW_KEY_RIGHT_BRACKET) change_speed(wind, +1);
    if (key == GLFW_KEY_COMMA) change_heading(wind, -1);
    if (key == GLFW_KEY_PERIOD) change_heading(wind, +1);
    if (key == GLFW_KEY_SEMICOLON) change_turbulence(wind, -1);
    if (key == GLFW_KEY_APOSTROPHE) change_turbulence(wind, +1);
    play_.set_wind(wind);
  }

  void press_for_walkers(int key) {
    if (key == GLFW_KEY_J) camera_.change_mode(world_);
    if (key == GLFW_KEY_K) camera_.watch_next(world_);
    if (key == GLFW_KEY_U) notice_ = steering_.toggle(camera_.watched());
    if (key == GLFW_KEY_X) walker_overlay_ = next_walker_overlay(walker_overlay_);
    steering_.keep_only(camera_.watched());
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
    perceive();
    const Picture picture = stage_->renderer.render(camera_.camera(), frame_options_, kScreenshotSamples);
    write_output(name, encoded_picture(picture, PictureFormat::kPng));
  }

  World& world_;
  const ViewerOptions& options_;
  WalkerCamera camera_;
  WalkerSteering steering_;
  WalkerTrails trails_;
  WalkerOverlay walker_overlay_ = WalkerOverlay::kNone;
  std::vector<Percept> percepts_;   // of this frame, where anything shows them
  std::vector<LineSegment> lines_;  // of this frame
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
