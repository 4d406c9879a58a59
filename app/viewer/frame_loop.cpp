#include "app/viewer/frame_loop.h"

#include <chrono>
#include <span>
#include <utility>

#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/terminal/messages.h"
#include "app/viewer/screenshot_name.h"
#include "render/gl/graphics_reset.h"

namespace prairie {
namespace {

FrameOptions with_lines(FrameOptions options, std::span<const LineSegment> lines) {
  options.lines = lines;
  return options;
}

}  // namespace

FrameLoop::FrameLoop(Session& session, WindowContents contents, const ViewerOptions& options)
    : session_(session), contents_(std::move(contents)), options_(options) {
  raise_stage(session.camera.camera().size_px);
}

void FrameLoop::raise_stage(glm::ivec2 size_px) {
  stage_.emplace(session_.world, size_px);
  // Later: what goes wrong with it must not be thrown through the window system, which calls this.
  stage_->window().on_key = [this](Key key) { keys_.push_back(key); };
  drawn_on_this_stage_ = false;
}

void FrameLoop::rebuild(const LostContext& lost) {
  const glm::ivec2 size_px = stage_->window().size_px();
  await_end_of_reset();
  stage_.reset();
  raise_stage(size_px);
  session_.notice = "drawing goes on after " + lost.found;
  say_warning(session_.notice);
}

void FrameLoop::run() {
  auto last = std::chrono::steady_clock::now();
  int frames = 0;
  // What was asked for before the window was closed is still done.
  while (frames != options_.frames && (stage_->window().poll() || is_asked())) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last;
    last = now;
    if (!stage_->window().can_be_seen()) continue;
    if (frames > 0) frame_times_.add(passed.count() * 1000.0);
    try {
      show_frame(passed.count());
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

void FrameLoop::show_frame(double passed_s) {
  Window& window = stage_->window();
  const Steering steering = window.steering(session_.panels_shown && stage_->panels_want_mouse());
  session_.move_camera(steering, passed_s, window.framebuffer_size_px());
  act();
  draw(passed_s, window.cart_controls(), steering.fast);
  if (session_.picture_wanted) take_screenshot();
}

void FrameLoop::act() {
  for (const std::string& name : std::exchange(chosen_, {})) perform(name, contents_.actions, session_);
  for (const Key key : std::exchange(keys_, {})) press(key, contents_.actions, session_);
  if (session_.end_wanted) stage_->window().close();
}

void FrameLoop::draw(double passed_s, const CartControls& arrows, bool fast) {
  const ShownWalkers walkers = session_.shown_walkers();
  FrameStatistics statistics =
      stage_->draw(session_.camera.camera(), with_lines(session_.frame_options, walkers.lines),
                   [&] { session_.advance(passed_s, arrows, fast); });
  if (session_.panels_shown) draw_panels(std::move(statistics), walkers);
  stage_->show_frame();
}

void FrameLoop::draw_panels(FrameStatistics statistics, const ShownWalkers& walkers) {
  const DrawnFrame frame{frame_times_.median_ms(), std::move(statistics), walkers.percepts};
  PanelInput input{session_, contents_.actions, frame, chosen_};
  stage_->draw_panels(contents_.windows, input);
}

void FrameLoop::take_screenshot() {
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

void FrameLoop::save_picture(const std::filesystem::path& name) {
  const ShownWalkers walkers = session_.shown_walkers();
  const Picture picture =
      stage_->picture(session_.camera.camera(), with_lines(session_.frame_options, walkers.lines));
  write_output(name, encoded_picture(picture, PictureFormat::kPng));
}

}  // namespace prairie
