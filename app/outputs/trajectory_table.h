// Where walkers were, as comma-separated text for other programs; agents/track_files.h reads it, too.
#pragma once

#include <string>

namespace prairie {

class World;

/// The line of column names: time_s, id, x_m, y_m, z_m, heading_rad (from east, counter-clockwise),
/// speed_m_per_s, d_m and theta_rad (distance of the nearest thing in sight from the walker's edge, and its
/// direction from the heading, counter-clockwise; empty where nothing is in sight, and for replayed walkers,
/// who look at nothing), left_planted, right_planted (0 or 1).
std::string trajectory_header();

/// A line for each walker that is present now.
std::string trajectory_rows(const World& world);

}  // namespace prairie
