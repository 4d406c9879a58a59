// How long a metre of a projected coordinate system is on the ground.
#pragma once

#include <glm/vec2.hpp>

#include "maps/georaster/spatial_reference.h"

namespace prairie {

/// Metres of the system per metre of ground at a place, eastwards and northwards; WGS 84's ellipsoid. (0, 0)
/// where the place is nowhere on Earth.
glm::dvec2 ground_scale(const SpatialReference& reference, glm::dvec2 place);

/// Longitude and latitude of a place on WGS 84, degrees; nothing where it is nowhere on Earth.
std::optional<glm::dvec2> longitude_latitude_deg(const SpatialReference& reference, glm::dvec2 place);

}  // namespace prairie
