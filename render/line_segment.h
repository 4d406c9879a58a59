// A straight line drawn over the picture (render/line_pass.h).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace prairie {

struct LineSegment {
  glm::dvec3 from_m{0.0};
  glm::dvec3 to_m{0.0};
  glm::vec4 color{1.0f};  // linear, as seen whatever the light and the exposure, and how much of it covers what is behind

  bool operator==(const LineSegment&) const = default;
};

}  // namespace prairie
