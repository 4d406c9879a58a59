#include "app/viewer/walker_trails.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "world/world.h"

namespace prairie {

glm::dvec3 on_ground_m(const World& world, std::size_t walker) {
  const glm::dvec2 place_m = world.walkers()[walker].position_m;
  return {place_m, static_cast<double>(world.meadow().ground.height_m(place_m))};
}

std::vector<std::uint32_t> nearest_walkers(const World& world, glm::dvec3 eye_m, std::size_t most) {
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::size_t n = 0; n < world.walkers().size(); ++n) {
    if (!world.is_present(n)) continue;
    const glm::dvec2 way_m = world.walkers()[n].position_m - glm::dvec2(eye_m);
    found.emplace_back(glm::dot(way_m, way_m), static_cast<std::uint32_t>(n));
  }
  if (found.size() > most) {
    std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most), found.end());
    found.resize(most);
  }
  std::vector<std::uint32_t> walkers;
  for (const auto& [squared_m2, walker] : found) walkers.push_back(walker);
  std::sort(walkers.begin(), walkers.end());
  return walkers;
}

void WalkerTrails::follow(const World& world, glm::dvec3 eye_m) {
  if (world.walkers().empty()) return;
  const double now_s = world.time_s();
  if (!samples_.empty() && now_s < samples_.back().time_s) samples_.clear();
  while (!samples_.empty() && samples_.front().time_s < now_s - kLengthS) samples_.pop_front();
  if (!samples_.empty() && now_s < samples_.back().time_s + kIntervalS) return;
  Sample sample{now_s, {}};
  for (const std::uint32_t walker : nearest_walkers(world, eye_m, kMostOverlaidWalkers))
    sample.places.push_back({walker, on_ground_m(world, walker)});
  samples_.push_back(std::move(sample));
}

}  // namespace prairie
