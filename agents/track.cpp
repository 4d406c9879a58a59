#include "agents/track.h"

#include <glm/geometric.hpp>

#include "animation/heading.h"

namespace prairie {

std::vector<Track> placed(std::vector<Track> tracks, glm::dvec2 origin_m, double turn_rad) {
  // The kernels' sine is good to 4e-7; without the length that comes of it nothing is stretched.
  const glm::dvec2 east = glm::normalize(direction_of(turn_rad));
  const glm::dvec2 north(-east.y, east.x);
  for (Track& track : tracks) {
    for (glm::dvec2& position_m : track.positions_m)
      position_m = origin_m + position_m.x * east + position_m.y * north;
  }
  return tracks;
}

}  // namespace prairie
