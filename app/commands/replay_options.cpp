#include "app/commands/replay_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "agents/track_files.h"
#include "agents/utm.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr const char* kReplay = "--replay";
constexpr double kFarthestM = 1e6;

ReplayPlace replay_place_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3)
    throw UsageError(option, text, "x,y[,deg]: metres, and degrees clockwise");
  ReplayPlace place;
  place.position_m = {number_option(option, parts[0], -kFarthestM, kFarthestM),
                      number_option(option, parts[1], -kFarthestM, kFarthestM)};
  if (parts.size() == 3)
    place.turn_rad = -number_option(option, parts[2], -360.0, 360.0) * std::numbers::pi / 180.0;
  return place;
}

struct Extent {
  glm::dvec2 min_m{std::numeric_limits<double>::max()};
  glm::dvec2 max_m{std::numeric_limits<double>::lowest()};
};

/// Of recordings whose clock does not begin with them, so that a short clip stays empty.
std::string late_beginning(const std::vector<Track>& tracks) {
  double first_s = std::numeric_limits<double>::max();
  for (const Track& track : tracks) first_s = std::min(first_s, track.times_s.front());
  constexpr double kSoonS = 5.0;
  if (first_s < kSoonS) return "";
  return fmt::format("nobody is seen before {:.2f} s; --time {:.2f} begins there", first_s, first_s);
}

/// What there is to say of tracks that lie beside the ground; empty where somebody comes onto it.
std::string off_the_ground(const std::vector<Track>& tracks, glm::dvec2 extent_m) {
  Extent all;
  for (const Track& track : tracks) {
    for (const glm::dvec2& at_m : track.positions_m) {
      const bool is_on_ground =
          at_m.x >= 0.0 && at_m.y >= 0.0 && at_m.x <= extent_m.x && at_m.y <= extent_m.y;
      if (is_on_ground) return "";
      all.min_m = glm::min(all.min_m, at_m);
      all.max_m = glm::max(all.max_m, at_m);
    }
  }
  const glm::dvec2 move_m = 0.5 * extent_m - 0.5 * (all.min_m + all.max_m);
  return fmt::format(
      "nobody of the tracks ever comes onto the ground: they lie from ({:.0f}, {:.0f}) to ({:.0f}, {:.0f}) "
      "m, the ground "
      "from (0, 0) to ({:.0f}, {:.0f}) m; --replay-at moves them, by {:.0f},{:.0f} into the middle",
      all.min_m.x, all.min_m.y, all.max_m.x, all.max_m.y, extent_m.x, extent_m.y, move_m.x, move_m.y);
}

}  // namespace

CommandOption replay_option(ReplayOptions& options) {
  return {.names = kReplay,
          .type = "FILE",
          .help =
              "Walkers go along recorded tracks instead: CSV (time_s,id,x_m,y_m), UCY obsmat.txt, TrajNet, "
              "Jülich or GPX",
          .target = text_into(options.file)};
}

CommandOption replay_at_option(ReplayOptions& options) {
  return {.names = "--replay-at",
          .type = "x,y[,deg]",
          .help = "Where the tracks' (0, 0) lies in the scene, and how far they are turned, clockwise",
          .target = parsed_into(options.at, replay_place_option),
          .needs = kReplay};
}

CommandOption replay_fps_option(ReplayOptions& options) {
  return {.names = "--replay-fps",
          .type = "N",
          .help = "Frames a second of tracks that count frames (what they say, or what makes a walk of them)",
          .target = number_into(options.frames_per_s, 0.01, 10'000.0),
          .needs = kReplay};
}

void replay_as_asked(const ReplayOptions& options, const GlobalOptions& globals, World& world) {
  if (options.file.empty()) return;
  std::optional<UtmFrame> frame;
  if (world.geo_reference()) frame = utm_frame_of(*world.geo_reference());
  TrackFile read = read_tracks(options.file, kReplay, {.scene = frame, .frames_per_s = options.frames_per_s});
  ReplayPlace place = options.at.value_or(ReplayPlace{});
  if (!options.at && read.is_on_earth && !frame) place.position_m = 0.5 * world.meadow().extent_m;
  std::vector<Track> tracks = placed(std::move(read.tracks), place.position_m, place.turn_rad);
  const auto warn = [&](const std::string& text) {
    if (!text.empty() && !globals.quiet)
      say_warning(fmt::format("{}: {}: {}", options.file.string(), kReplay, text));
  };
  for (const std::string& note : read.notes) warn(note);
  warn(late_beginning(tracks));
  if (!world.meadow().repeats) warn(off_the_ground(tracks, world.meadow().extent_m));
  world.replay(std::move(tracks));
}

}  // namespace prairie
