// What a walker's feet do to the grass in a step (G03 §5.4): each presses by itself, from heel to toes as it
// rolls on after it has struck. One that stands on keeps its grass down; in between nothing has to be said,
// for grass takes longer to rise than a stance lasts.
#pragma once

#include <cstdint>
#include <vector>

#include "agents/footing.h"
#include "animation/treading.h"

namespace prairie {

inline constexpr std::uint32_t kTreadIdsPerWalker = 2;

/// Appends the steps from one footing to the next; `first_id`: of the left foot, the right one's follows.
void add_foot_treads(const Footing& before, const Footing& after, std::uint32_t first_id,
                     std::vector<TreadStep>& steps);

}  // namespace prairie
