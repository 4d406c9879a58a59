// What the viewer's overlay says of the walkers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "agents/behaviour.h"

namespace prairie {

class World;

/// θ: the angle from where a walker looks to what it perceives, to the left positive, −π…π.
double angle_to_percept_rad(const Percept& percept, glm::dvec2 forward);

/// How many walk; nothing where nobody is known at all.
std::string walkers_line(const World& world);

/// The watched walker: its speed, what it perceives, (d, θ), its behaviour, whether it is steered.
/// `percepts`: of all, empty for those who replay tracks.
std::string watched_walker_line(const World& world, std::size_t walker, std::span<const Percept> percepts);

}  // namespace prairie
