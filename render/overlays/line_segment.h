// A straight line drawn over the picture (render/overlays/line_pass.h).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace prairie {

struct LineSegment {
  glm::dvec3 from_m{0.0};
  glm::dvec3 to_m{0.0};
  glm::vec4 color{1.0f};  // linear, the same in any light and exposure; alpha: its cover

  bool operator==(const LineSegment&) const = default;
};

}  // namespace prairie
