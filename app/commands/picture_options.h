// The options that all commands share that draw pictures without a window. What they set must live as long as
// the command.
#pragma once

#include <CLI/App.hpp>
#include <glm/vec2.hpp>

#include "lod/frame_plan.h"

namespace prairie {

/// `--size`; the size that is there is the default.
void add_size_option(CLI::App& command, glm::ivec2& size_px);
void add_samples_option(CLI::App& command, int& samples);
void add_tier_option(CLI::App& command, Tier& tier);

}  // namespace prairie
