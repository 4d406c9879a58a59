// The largest circle without a point: how uneven a set of points is.
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace prairie {

/// Radius of the largest empty circle on the torus [0, 1)², its centre searched on a grid of 64 × 64 and
/// refined around the best places: within 0.5 % for up to a few hundred points.
double largest_empty_circle(std::span<const glm::dvec2> points);

/// The same with centres in [0, 1]² and no points beyond it.
double largest_empty_circle_in_square(std::span<const glm::dvec2> points);

}  // namespace prairie
