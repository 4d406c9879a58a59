// The options that commands share that draw pictures. What is set must live as long as the command.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "app/commands/command.h"
#include "lod/frame_plan.h"

namespace prairie {

/// `--size`; the size that is there is the default.
CommandOption picture_size_option(glm::ivec2& size_px);
/// `--samples`
CommandOption picture_samples_option(int& samples);
/// `--parallel`: a parallel projection of that height, metres; else perspective.
CommandOption parallel_option(std::optional<double>& height_m);
/// `--tier`
CommandOption picture_tier_option(Tier& tier);
/// `--lod-eye`; `default_eye` says whose eye it is otherwise.
CommandOption lod_eye_option(std::optional<glm::dvec3>& lod_eye_m, const std::string& default_eye);

}  // namespace prairie
