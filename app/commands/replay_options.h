// `--replay` and `--replay-at`: walkers go along recorded tracks instead of their own ways, in every command
// that shows or steps a world; a state that was saved with tracks is loaded with them.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>

#include "app/commands/command.h"
#include "app/terminal/global_options.h"

namespace prairie {

class World;

struct ReplayPlace {
  glm::dvec2 position_m{0.0};
  double turn_rad = 0.0;  // counter-clockwise
};

struct ReplayOptions {
  std::filesystem::path file;  // empty: nobody is replayed
  std::optional<ReplayPlace> at;
  std::optional<double> frames_per_s;
};

/// What they set must live as long as the command.
CommandOption replay_option(ReplayOptions& options);
CommandOption replay_at_option(ReplayOptions& options);
CommandOption replay_fps_option(ReplayOptions& options);

/// Has the world's walkers go along the tracks, if some are asked for. To be called before any step or state.
/// Tracks lie where their file says; of places on Earth without a georeferenced ground the first lies in the
/// middle. Warns where nobody ever comes onto the ground. Throws BadInput.
void replay_as_asked(const ReplayOptions& options, const GlobalOptions& globals, World& world);

}  // namespace prairie
