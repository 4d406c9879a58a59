#include "app/viewer/actions.h"

#include <initializer_list>
#include <iterator>

#include "app/viewer/frame_choices.h"
#include "world/world.h"

namespace prairie {
namespace {

bool is_free(const Session& session) {
  return session.camera.mode() == CameraMode::kFree;
}

bool is_bound(const Session& session) {
  return !is_free(session);
}

bool turns_by_hand(const Session& session) {
  return session.camera.mode() != CameraMode::kFollow;
}

bool time_goes(const Session& session) {
  return !session.play.paused();
}

bool time_pauses(const Session& session) {
  return session.play.paused();
}

bool has_cart(const Session& session) {
  return session.play.has_cart();
}

bool has_no_cart(const Session& session) {
  return !session.play.has_cart();
}

bool steers_walker(const Session& session) {
  return session.steering.steered().has_value();
}

bool hastens(const Session& session) {
  return is_free(session) || steers_walker(session);
}

bool drives_cart(const Session& session) {
  return has_cart(session) && !steers_walker(session);
}

bool has_walkers(const Session& session) {
  return session.has_walkers();
}

std::vector<Action> move_actions() {
  return {
      {.name = "move",
       .menu = "move",
       .keys = {'W', 'A', 'S', 'D'},
       .label = "move",
       .help = "move; the eye stirs the grass that it passes",
       .is_available = is_free},
      {.name = "sink-or-rise",
       .menu = "move",
       .keys = {'Q', 'E'},
       .label = "sink, rise",
       .help = "sink, rise (flying)",
       .is_available = is_free},
      {.name = "hasten",
       .menu = "move",
       .keys = {NamedKey::kShift},
       .label = "fast",
       .help = "move five times as fast; a steered walker walks at 2 m/s",
       .is_available = hastens},
      {.name = "turn",
       .menu = "move",
       .keys = {NamedKey::kMouseDrag},
       .label = "turn",
       .help = "turn, by dragging the mouse with its left or right button",
       .is_available = turns_by_hand},
      {.name = "walk-or-fly",
       .menu = "move",
       .keys = {'F'},
       .label = "walk, fly",
       .help = "walk or fly",
       .perform = [](Session& session) { session.camera.toggle_walking(session.world.meadow().ground); },
       .is_available = is_free},
  };
}

std::vector<Action> time_actions() {
  return {
      {.name = "pause",
       .menu = "time",
       .keys = {'P'},
       .label = "pause",
       .help = "pause time",
       .perform = [](Session& session) { session.play.toggle_pause(); },
       .is_available = time_goes,
       .has_button = true},
      {.name = "go-on",
       .menu = "time",
       .keys = {'P'},
       .label = "go on",
       .help = "let time go on",
       .perform = [](Session& session) { session.play.toggle_pause(); },
       .is_available = time_pauses,
       .has_button = true},
      {.name = "step",
       .menu = "time",
       .keys = {'N'},
       .label = "step",
       .help = "one step of a thirtieth of a second while time pauses",
       .perform = [](Session& session) { session.play.step_once(); },
       .is_available = time_pauses,
       .has_button = true},
  };
}

std::function<void(Session&)> changes_wind(void (*change)(WindControls&, int), int steps) {
  return [change, steps](Session& session) {
    WindControls wind = session.play.wind();
    change(wind, steps);
    session.play.set_wind(wind);
  };
}

std::vector<Action> steady_wind_actions() {
  return {
      {.name = "lower-wind-speed",
       .menu = "wind",
       .keys = {'['},
       .label = "speed",
       .help = "lower the wind's speed by 1 m/s",
       .perform = changes_wind(change_speed, -1)},
      {.name = "raise-wind-speed",
       .menu = "wind",
       .keys = {']'},
       .label = "speed",
       .help = "raise the wind's speed by 1 m/s",
       .perform = changes_wind(change_speed, +1)},
      {.name = "turn-wind-counterclockwise",
       .menu = "wind",
       .keys = {','},
       .label = "heading",
       .help = "turn the wind by 15° against the clock",
       .perform = changes_wind(change_heading, -1)},
      {.name = "turn-wind-clockwise",
       .menu = "wind",
       .keys = {'.'},
       .label = "heading",
       .help = "turn the wind by 15° with the clock",
       .perform = changes_wind(change_heading, +1)},
      {.name = "lower-turbulence",
       .menu = "wind",
       .keys = {';'},
       .label = "turbulence",
       .help = "lower the wind's turbulence by a quarter of what is usual",
       .perform = changes_wind(change_turbulence, -1)},
      {.name = "raise-turbulence",
       .menu = "wind",
       .keys = {'\''},
       .label = "turbulence",
       .help = "raise the wind's turbulence by a quarter of what is usual",
       .perform = changes_wind(change_turbulence, +1)},
  };
}

std::vector<Action> sudden_wind_actions() {
  return {
      {.name = "send-gust",
       .menu = "wind",
       .keys = {'B'},
       .label = "gust",
       .help = "send a gust from behind the camera",
       .perform = [](Session& session) { session.play.send_gust(session.camera.camera()); },
       .has_button = true},
      {.name = "send-tornado",
       .menu = "wind",
       .keys = {'V'},
       .label = "tornado",
       .help = "drop a tornado 15 m ahead",
       .perform = [](Session& session) { session.play.send_tornado(session.camera.camera()); },
       .has_button = true},
  };
}

std::vector<Action> thing_actions() {
  return {
      {.name = "roll-stone",
       .menu = "things",
       .keys = {'R'},
       .label = "stone",
       .help = "let a stone roll from 4 m ahead, at 2 m/s for 40 m; there is one at a time",
       .perform = [](Session& session) { session.play.roll_stone(session.camera.camera()); },
       .has_button = true},
      {.name = "take-cart",
       .menu = "things",
       .keys = {'C'},
       .label = "cart",
       .help = "take a cart, which stands 4 m ahead",
       .perform = [](Session& session) { session.play.take_cart(session.camera.camera()); },
       .is_available = has_no_cart,
       .has_button = true},
      {.name = "leave-cart",
       .menu = "things",
       .keys = {'C'},
       .label = "leave cart",
       .help = "leave the cart",
       .perform = [](Session& session) { session.play.leave_cart(); },
       .is_available = has_cart,
       .has_button = true},
      {.name = "drive-cart",
       .menu = "things",
       .keys = {NamedKey::kArrows},
       .label = "drive the cart",
       .help = "drive the cart: up pulls, down brakes and then backs, left and right steer",
       .is_available = drives_cart},
  };
}

std::function<void(Session&)> changes_quality(int steps) {
  return [steps](Session& session) {
    session.frame_options.quality = stepped(session.frame_options.quality.value(), steps);
  };
}

std::vector<Action> grass_actions() {
  return {
      {.name = "next-tier",
       .menu = "grass",
       .keys = {'T'},
       .label = "tier",
       .help = "next tier: auto, spline, Hermite, strip, flat",
       .perform =
           [](Session& session) { session.frame_options.tier = next_tier(session.frame_options.tier); }},
      {.name = "tint-tiers",
       .menu = "grass",
       .keys = {'G'},
       .label = "tint tiers",
       .help = "colour each tier: spline red, Hermite yellow, strips green, flat blue",
       .perform =
           [](Session& session) { session.frame_options.tier_tint = !session.frame_options.tier_tint; }},
      {.name = "lower-quality",
       .menu = "grass",
       .keys = {'-', NamedKey::kKeypadSubtract},
       .label = "quality",
       .help = "lower the quality (lod.quality)",
       .perform = changes_quality(-1)},
      {.name = "raise-quality",
       .menu = "grass",
       .keys = {'=', NamedKey::kKeypadAdd},
       .label = "quality",
       .help = "raise the quality (lod.quality)",
       .perform = changes_quality(+1)},
      {.name = "next-field",
       .menu = "grass",
       .keys = {'O'},
       .label = "fields",
       .help = "show a field: none, the wind as arrows, trodden grass, recovery and wear",
       .perform =
           [](Session& session) {
             session.frame_options.field_overlay = next_overlay(session.frame_options.field_overlay);
           },
       .has_button = true},
  };
}

std::vector<Action> walker_actions() {
  return {
      {.name = "watch-next-walker",
       .menu = "walkers",
       .keys = {'K'},
       .label = "next walker",
       .help = "watch the next walker, at first the one nearest to the middle of the view",
       .perform = [](Session& session) { session.watch_next_walker(); },
       .is_available = has_walkers,
       .has_button = true},
      {.name = "change-camera",
       .menu = "walkers",
       .keys = {'J'},
       .label = "camera",
       .help = "the camera: free, behind the watched walker, about it, free again",
       .perform = [](Session& session) { session.camera.change_mode(session.world); },
       .is_available = has_walkers,
       .has_button = true},
      {.name = "change-distance",
       .menu = "walkers",
       .keys = {NamedKey::kMouseWheel, 'Q', 'E'},
       .label = "nearer, farther",
       .help = "nearer to the walker to which the camera is bound, or farther from it",
       .is_available = is_bound},
      {.name = "steer-walker",
       .menu = "walkers",
       .keys = {'U'},
       .label = "steer",
       .help = "take the watched walker, or give it back",
       .perform =
           [](Session& session) { session.notice = session.steering.toggle(session.camera.watched()); },
       .is_available = has_walkers,
       .has_button = true},
      {.name = "walk",
       .menu = "walkers",
       .keys = {NamedKey::kArrows},
       .label = "walk, turn",
       .help = "steer the walker that was taken: up walks, left and right turn, down stands",
       .is_available = steers_walker},
      {.name = "next-walker-lines",
       .menu = "walkers",
       .keys = {'X'},
       .label = "sensors and paths",
       .help = "lines: none, what walkers perceive, their paths, both",
       .perform =
           [](Session& session) { session.walker_overlay = next_walker_overlay(session.walker_overlay); },
       .is_available = has_walkers,
       .has_button = true},
  };
}

std::vector<Action> view_actions() {
  return {
      {.name = "smooth-edges",
       .menu = "view",
       .keys = {'M'},
       .label = "smooth edges",
       .help = "smooth edges on or off",
       .perform = [](Session& session) { session.frame_options.msaa = !session.frame_options.msaa; }},
      {.name = "save-picture",
       .menu = "view",
       .keys = {NamedKey::kF12},
       .label = "picture",
       .help = "save the view without the panels as prairie-0001.png, … in the current folder",
       .perform = [](Session& session) { session.picture_wanted = true; }},
      {.name = "show-panels",
       .menu = "view",
       .keys = {'H'},
       .label = "hide",
       .help = "hide or show the panels",
       .perform = [](Session& session) { session.panels_shown = !session.panels_shown; }},
      {.name = "end",
       .menu = "view",
       .keys = {NamedKey::kEscape},
       .label = "end",
       .help = "end",
       .perform = [](Session& session) { session.end_wanted = true; }},
  };
}

}  // namespace

std::vector<Action> viewer_actions() {
  std::vector<Action> all;
  for (const auto& actions : {move_actions(), time_actions(), steady_wind_actions(), sudden_wind_actions(),
                              thing_actions(), grass_actions(), walker_actions(), view_actions()})
    all.insert(all.end(), actions.begin(), actions.end());
  return all;
}

}  // namespace prairie
