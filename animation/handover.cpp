#include "animation/handover.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace prairie {

float tip_gap(const ChainVectors& rest, const ChainVectors& turn, const ChainVectors& other) {
  const ChainVectors a = Kernels{}.chain_directions(rest, turn), b = Kernels{}.chain_directions(rest, other);
  return 0.25f * glm::length((a.v1 - b.v1) + (a.v2 - b.v2) + (a.v3 - b.v3) + (a.v4 - b.v4));
}

ChainVectors faded(const ChainVectors& offset, float most_share) {
  // Each segment, a quarter of the blade, moves its end by no more than the change of its turn.
  const float reach = 0.25f * (glm::length(offset.v1) + glm::length(offset.v2) + glm::length(offset.v3) +
                               glm::length(offset.v4));
  const float kept = reach > most_share ? 1.0f - most_share / reach : 0.0f;
  return Kernels{}.chain_scaled(offset, kept);
}

}  // namespace prairie
