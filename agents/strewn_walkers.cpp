#include "agents/strewn_walkers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "agents/plan_cell.h"
#include "agents/plane_vectors.h"
#include "agents/skeleton.h"
#include "agents/walker_noise.h"
#include "animation/heading.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr int kMostTries = 400;   // to find room for a walker
constexpr double kApartM = 0.05;  // of those who find their place by themselves
constexpr double kCellM = 2.0;    // at least as wide as two bodies

/// Puts walkers down one after the other.
class Strewing {
 public:
  Strewing(const ObstacleMap& obstacles, std::uint32_t seed) : obstacles_(obstacles), seed_(seed) {}

  void add(const WalkerGroup& group, std::uint32_t group_index, std::uint32_t member) {
    const auto id = static_cast<std::uint32_t>(strewn_.walkers.size());
    const std::array<double, 3> own = units(seed_, id, NoiseOf::kTraits, 0);
    WalkerTraits traits = traits_of(group, own);
    traits.group = group_index;
    traits.id = id;
    Walker walker;
    walker.forward = unit(direction_of(kFullTurn * own[2]), {1.0, 0.0});
    walker.position_m =
        group.starts_m.empty() ? free_place(group, traits, member) : given_place(group, traits, member);
    traits.home_m = walker.position_m;
    walker.footing = standing(walker.position_m, walker.forward, traits.height_m / kFigureHeightM);
    placed_[key_of(plan_cell(walker.position_m, kCellM))].push_back(id);
    strewn_.traits.push_back(traits);
    strewn_.walkers.push_back(walker);
  }

  StrewnWalkers take() { return std::move(strewn_); }

 private:
  static constexpr double kFullTurn = 2.0 * std::numbers::pi;

  static WalkerTraits traits_of(const WalkerGroup& group, const std::array<double, 3>& own) {
    const auto spread = [](double unit_share, double most) { return 1.0 + most * (2.0 * unit_share - 1.0); };
    WalkerTraits traits;
    traits.height_m = group.height_m * spread(own[0], group.height_spread);
    traits.radius_m = group.body_radius_m * traits.height_m / kFigureHeightM;
    traits.speed_m_per_s = group.speed_m_per_s * spread(own[1], group.speed_spread);
    traits.sensor_m = group.sensor_m;
    traits.noise = group.noise;
    traits.behaviour = find_behaviour(group.behaviour);
    return traits;
  }

  glm::dvec2 given_place(const WalkerGroup& group, const WalkerTraits& traits, std::uint32_t member) const {
    const glm::dvec2 place_m = group.starts_m[member];
    const char* fault = obstruction({place_m, traits.radius_m}, 0.0);
    if (fault == nullptr) return place_m;
    throw BadInput("", "starts_m",
                   fmt::format("walker {} {} ([{}, {}])", member, fault, place_m.x, place_m.y),
                   "a free place");
  }

  glm::dvec2 free_place(const WalkerGroup& group, const WalkerTraits& traits, std::uint32_t member) const {
    for (std::uint32_t attempt = 0; attempt < kMostTries; ++attempt) {
      const std::array<double, 3> dart = units(seed_, traits.id, NoiseOf::kStart, attempt);
      const glm::dvec2 place_m =
          group.centre_m + group.radius_m * std::sqrt(dart[0]) * direction_of(kFullTurn * dart[1]);
      if (obstruction({place_m, traits.radius_m}, kApartM) == nullptr) return place_m;
    }
    throw BadInput("", "radius_m", fmt::format("no room for walker {} of {}", member + 1, group.count),
                   "a wider disc, or one with fewer obstacles");
  }

  /// What is in the way of a body, if anything.
  const char* obstruction(const Disc& body, double apart_m) const {
    for (const std::uint32_t n : obstacles_.near(body.centre_m)) {
      if (is_beyond(obstacles_.box(n), body.centre_m, body.radius_m + apart_m)) continue;
      if (plan_distance(body, obstacles_.footprints()[n]).distance_m < apart_m)
        return "inside of an obstacle or beyond a wall";
    }
    const PlanCell here = plan_cell(body.centre_m, kCellM);
    for (int j = here.j - 1; j <= here.j + 1; ++j) {
      for (int i = here.i - 1; i <= here.i + 1; ++i) {
        const auto cell = placed_.find(key_of({i, j}));
        if (cell == placed_.end()) continue;
        for (const std::uint32_t other : cell->second) {
          const Disc there{strewn_.walkers[other].position_m, strewn_.traits[other].radius_m};
          if (disc_distance(body, there).distance_m < apart_m) return "on the place of another walker";
        }
      }
    }
    return nullptr;
  }

  const ObstacleMap& obstacles_;
  std::uint32_t seed_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> placed_;  // by cells
  StrewnWalkers strewn_;
};

}  // namespace

StrewnWalkers strewn_walkers(std::span<const WalkerGroup> groups, const ObstacleMap& obstacles,
                             std::uint32_t seed) {
  std::size_t total = 0;
  for (const WalkerGroup& group : groups) total += group.count;
  if (total > kMostWalkers)
    throw BadInput("", "count", fmt::format("{} walkers", total),
                   fmt::format("at most {} in all", kMostWalkers));
  Strewing strewing(obstacles, seed);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    check(groups[g]);
    for (std::uint32_t n = 0; n < groups[g].count; ++n)
      strewing.add(groups[g], static_cast<std::uint32_t>(g), n);
  }
  return strewing.take();
}

}  // namespace prairie
