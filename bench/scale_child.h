// Child processes of the bench `scale`: what can be told of a process only once, its way from the start to
// the first picture and the most memory that it ever held.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace prairie {

/// The tasks.
inline constexpr const char* kWalkTask = "walk";
inline constexpr const char* kRepeatedWalkTask = "walk-repeated";

/// What `prairie bench TASK --child FOLDER` does: loads the scene, draws the walk, and says when the first
/// frame was there and what it held.
std::vector<Measurement> run_scale_child(const std::string& task, const std::filesystem::path& folder,
                                         const BenchOptions& options);

}  // namespace prairie
