#include "agents/crowd.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "agents/foot_treads.h"
#include "agents/free_step.h"
#include "agents/plan_cell.h"
#include "agents/plane_vectors.h"
#include "agents/skeleton.h"
#include "agents/strewn_walkers.h"
#include "agents/walker_noise.h"
#include "animation/heading.h"
#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr double kSkinM = 1e-4;          // that bodies keep between them
constexpr double kFastestM_per_s = 3.5;  // of anybody
constexpr double kMostPushM = 1.0;       // by a mover, in a step
constexpr double kFasterM_per_s2 = 1.2, kSlowerM_per_s2 = 3.0;
constexpr double kTurnRate = 3.5;  // 1/s, of the angle that is left
constexpr double kMostTurnRad_per_s = 2.6;
constexpr std::size_t kMostLimits = 24, kMostFirmLimits = 20;  // the others are for movers
constexpr double kStandsBelow = 1e-3;                          // m/s

/// Towards `wanted` by what a step's time allows.
glm::dvec2 turned_towards(glm::dvec2 forward, glm::dvec2 wanted, double dt_s) {
  const double c = glm::dot(forward, wanted), s = glm::dot(left_of(forward), wanted);
  // The tangent of half the angle between them; behind the walker any large number does.
  const double half = c > -0.999 ? s / (1.0 + c) : (s < 0.0 ? -30.0 : 30.0);
  const double most = 0.5 * kMostTurnRad_per_s * dt_s;
  const double t = std::clamp(std::min(kTurnRate * dt_s, 1.0) * half, -most, most);
  return unit(turned_by_half_tangent(forward, t), forward);
}

/// Tobler 1993, "Three presentations on geographical analysis and modeling", relative to level ground.
double share_on_slope(double grade) {
  return static_cast<double>(
             Kernels{}.falling_exponential(static_cast<float>(3.5 * std::abs(grade + 0.05)))) /
         0.8394570;
}

void nearer(const PlanDistance& found, Percept::Kind kind, Percept& nearest) {
  if (found.distance_m < nearest.distance_m) nearest = {kind, found.distance_m, found.toward};
}

double reach_of(std::span<const WalkerGroup> groups) {
  double reach_m = 0.0;
  for (const WalkerGroup& group : groups) reach_m = std::max(reach_m, group.sensor_m);
  return reach_m + 2.0;
}

}  // namespace

/// The walkers by the cells they are in.
class Crowd::Neighbours {
 public:
  Neighbours(std::span<const Walker> walkers, std::span<const WalkerTraits> traits) {
    for (const WalkerTraits& one : traits) {
      cell_m_ = std::max(cell_m_, one.sensor_m);
      widest_m_ = std::max(widest_m_, one.radius_m);
    }
    cell_m_ += 2.0 * widest_m_;
    entries_.reserve(walkers.size());
    for (std::uint32_t n = 0; n < walkers.size(); ++n)
      entries_.push_back({key_of(plan_cell(walkers[n].position_m, cell_m_)), n});
    std::sort(entries_.begin(), entries_.end());
    // Beside one another in memory, as they are looked at.
    bodies_.reserve(entries_.size());
    for (const Entry& entry : entries_)
      bodies_.push_back({walkers[entry.walker].position_m, traits[entry.walker].radius_m});
  }

  /// Calls `visit(index, body)` for all whose bodies may be within the longest sensor range; in an order that
  /// depends on their places alone.
  template <class Visitor>
  void for_near(glm::dvec2 position_m, Visitor visit) const {
    const PlanCell here = plan_cell(position_m, cell_m_);
    for (int j = here.j - 1; j <= here.j + 1; ++j) {
      const std::int64_t last = key_of({here.i + 1, j});
      auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{key_of({here.i - 1, j}), 0});
      for (; at != entries_.end() && at->key <= last; ++at)
        visit(at->walker, bodies_[static_cast<std::size_t>(at - entries_.begin())]);
    }
  }

 private:
  struct Entry {
    std::int64_t key;
    std::uint32_t walker;
    auto operator<=>(const Entry&) const = default;
  };
  double cell_m_ = 1.0, widest_m_ = 0.0;
  std::vector<Entry> entries_;
  std::vector<Disc> bodies_;  // of the entries
};

Crowd::Crowd(const Gait& gait) : obstacles_({}, 1.0), gait_(gait) {}

Crowd::Crowd(std::span<const WalkerGroup> groups, std::vector<Footprint> obstacles, Gait gait,
             std::uint64_t seed)
    : obstacles_(std::move(obstacles), reach_of(groups)),
      gait_(gait),
      seed_(Kernels{}.hash_u32(static_cast<std::uint32_t>(seed) ^
                               Kernels{}.hash_u32(static_cast<std::uint32_t>(seed >> 32)))) {
  for (const WalkerGroup& group : groups) groups_.push_back({group.goals});
  StrewnWalkers strewn = strewn_walkers(groups, obstacles_, seed_);
  walkers_ = std::move(strewn.walkers);
  traits_ = std::move(strewn.traits);
  steered_.resize(walkers_.size());
}

Percept Crowd::perceived(std::size_t index, const Neighbours& neighbours,
                         std::span<const Footprint> movers) const {
  const WalkerTraits& traits = traits_[index];
  const Disc body{walkers_[index].position_m, traits.radius_m};
  Percept nearest{Percept::Kind::kNothing, traits.sensor_m, walkers_[index].forward};
  neighbours.for_near(body.centre_m, [&](std::uint32_t other, const Disc& there) {
    if (other != index) nearer(disc_distance(body, there), Percept::Kind::kWalker, nearest);
  });
  for (const std::uint32_t n : obstacles_.near(body.centre_m)) {
    if (is_beyond(obstacles_.box(n), body.centre_m, body.radius_m + nearest.distance_m)) continue;
    nearer(plan_distance(body, obstacles_.footprints()[n]), Percept::Kind::kObstacle, nearest);
  }
  for (const Footprint& mover : movers) {
    if (is_beyond(box_of(mover), body.centre_m, body.radius_m + nearest.distance_m)) continue;
    nearer(plan_distance(body, mover), Percept::Kind::kMover, nearest);
  }
  return nearest;
}

std::vector<Percept> Crowd::percepts(std::span<const Footprint> movers) const {
  const Neighbours neighbours(walkers_, traits_);
  std::vector<Percept> percepts(walkers_.size());
  oneapi::tbb::parallel_for(std::size_t{0}, walkers_.size(),
                            [&](std::size_t n) { percepts[n] = perceived(n, neighbours, movers); });
  return percepts;
}

MotorCommand Crowd::decided(std::size_t index, const Percept& nearest, double time_s, Memory& memory) const {
  if (steered_[index]) return *steered_[index];
  const WalkerTraits& traits = traits_[index];
  const Walker& walker = walkers_[index];
  Sight sight;
  sight.time_s = time_s;
  sight.position_m = walker.position_m;
  sight.forward = walker.forward;
  sight.moving_m_per_s = walker.speed_m_per_s;
  sight.nearest = nearest;
  sight.sensor_m = traits.sensor_m;
  sight.speed_m_per_s = traits.speed_m_per_s;
  sight.home_m = traits.home_m;
  sight.turn_noise = noise_at(seed_, traits.id, NoiseOf::kWander, 0.5 * time_s);
  sight.goals = groups_[traits.group].goals;
  MotorCommand command = traits.behaviour->decide(sight, memory);
  const double sigma = noise_deviation(traits.noise, nearest.distance_m, traits.sensor_m);
  command.speed_m_per_s *= std::max(1.0 + sigma * noise_at(seed_, traits.id, NoiseOf::kSpeed, time_s), 0.0);
  const double aside = sigma * noise_at(seed_, traits.id, NoiseOf::kHeading, time_s);
  command.heading = unit(command.heading + aside * left_of(command.heading), command.heading);
  return command;
}

Walker Crowd::moved(std::size_t index, const Neighbours& neighbours, const CrowdSurroundings& around,
                    double time_s, double dt_s) const {
  const WalkerTraits& traits = traits_[index];
  Walker walker = walkers_[index];
  const Disc body{walker.position_m, traits.radius_m};
  const Percept nearest = perceived(index, neighbours, around.movers);
  const MotorCommand command = decided(index, nearest, time_s, walker.memory);

  // Speed and heading follow the command (G03 §5.3).
  walker.forward = turned_towards(walker.forward, command.heading, dt_s);
  const glm::dvec2 slope(around.ground.slope(walker.position_m));
  const double grade = glm::dot(slope, walker.forward);
  const double effort = around.effort ? around.effort(walker.position_m) : 1.0;
  const double facing = 0.5 + 0.5 * glm::dot(walker.forward, command.heading);
  const double wanted =
      std::min(command.speed_m_per_s * facing * share_on_slope(grade) / effort, kFastestM_per_s);
  walker.speed_m_per_s +=
      std::clamp(wanted - walker.speed_m_per_s, -kSlowerM_per_s2 * dt_s, kFasterM_per_s2 * dt_s);

  // A step never exceeds the free distance.
  std::array<StepLimit, kMostLimits> limits;
  std::size_t count = 0;
  const double reach_m = 2.0 * kFastestM_per_s * dt_s + kSkinM;
  // No more bodies fit around one; of the many pieces of a wall that may meet at a corner, the nearest count.
  const auto limit = [&](glm::dvec2 toward, double room_m) {
    if (count < kMostFirmLimits) {
      limits[count++] = {toward, room_m};
      return;
    }
    const auto farthest =
        std::max_element(limits.begin(), limits.begin() + kMostFirmLimits,
                         [](const StepLimit& a, const StepLimit& b) { return a.room_m < b.room_m; });
    if (farthest->room_m > room_m) *farthest = {toward, room_m};
  };
  if (nearest.distance_m < reach_m) {
    neighbours.for_near(body.centre_m, [&](std::uint32_t other, const Disc& there) {
      if (other == index) return;
      const PlanDistance found = disc_distance(body, there);
      if (found.distance_m < reach_m) limit(found.toward, 0.5 * (found.distance_m - kSkinM));
    });
    for (const std::uint32_t n : obstacles_.near(body.centre_m)) {
      if (is_beyond(obstacles_.box(n), body.centre_m, body.radius_m + reach_m)) continue;
      const PlanDistance found = plan_distance(body, obstacles_.footprints()[n]);
      if (found.distance_m < reach_m) limit(found.toward, found.distance_m - kSkinM);
    }
  }
  const std::size_t firm = count;
  for (const Footprint& mover : around.movers) {
    if (is_beyond(box_of(mover), body.centre_m, body.radius_m + reach_m)) continue;
    const PlanDistance found = plan_distance(body, mover);
    if (found.distance_m < reach_m && count < kMostLimits)
      limits[count++] = {found.toward, std::max(found.distance_m - kSkinM, -kMostPushM)};
  }
  const glm::dvec2 wanted_m = walker.speed_m_per_s * dt_s * walker.forward;
  const std::span<const StepLimit> all(limits.data(), count);
  glm::dvec2 step_m = free_step(wanted_m, all);
  const bool is_pinned =
      std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(firm), [&](const StepLimit& one) {
        return glm::dot(one.toward, step_m) > std::max(one.room_m, 0.0) + kSkinM;
      });
  if (is_pinned) step_m = free_step(wanted_m, all.first(firm));  // sooner under a mover than inside of a wall

  walker.position_m += step_m;
  const double speed = glm::length(step_m) / dt_s;
  walker.speed_m_per_s = std::min(walker.speed_m_per_s, speed);
  if (walker.speed_m_per_s < kStandsBelow) walker.speed_m_per_s = 0.0;
  advance(walker.footing, gait_, {walker.position_m, walker.forward, std::min(speed, kFastestM_per_s), grade},
          dt_s);
  return walker;
}

std::vector<TreadStep> Crowd::step(const CrowdSurroundings& around, double time_s, double dt_s,
                                   std::uint32_t first_id) {
  assert(dt_s > 0.0 && dt_s <= 0.1);
  std::vector<TreadStep> treads;
  if (walkers_.empty()) return treads;
  const Neighbours neighbours(walkers_, traits_);
  std::vector<Walker> after(walkers_.size());
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, walkers_.size(), 32),
                            [&](const auto& range) {
                              for (std::size_t n = range.begin(); n != range.end(); ++n)
                                after[n] = moved(n, neighbours, around, time_s, dt_s);
                            });
  for (std::uint32_t n = 0; n < after.size(); ++n)
    add_foot_treads(walkers_[n].footing, after[n].footing, first_id + n * kTreadIdsPerWalker, treads);
  walkers_ = std::move(after);
  return treads;
}

void Crowd::steer(std::size_t walker, const MotorCommand& command) {
  assert(walker < steered_.size() && command.speed_m_per_s >= 0.0);
  steered_[walker] = command;
}

void Crowd::release(std::size_t walker) {
  steered_[walker].reset();
}

void Crowd::restore(std::vector<Walker> walkers) {
  const auto refuse = [](const std::string& found, const std::string& expected) {
    throw BadInput("", "walkers", found, expected);
  };
  if (walkers.size() != walkers_.size())
    refuse(fmt::format("{} walkers", walkers.size()), fmt::format("{}, the scene's", walkers_.size()));
  constexpr double kFarthestM = 1e7;
  const auto is_place = [](glm::dvec2 p) {
    return std::abs(p.x) <= kFarthestM && std::abs(p.y) <= kFarthestM;
  };
  const auto is_unit = [](glm::dvec2 v) { return std::abs(glm::dot(v, v) - 1.0) < 1e-6; };
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    const Walker& walker = walkers[n];
    bool is_good = is_place(walker.position_m) && is_unit(walker.forward) && walker.speed_m_per_s >= 0.0 &&
                   walker.speed_m_per_s <= 2.0 * kFastestM_per_s;
    check(walker.footing);
    is_good = is_good && walker.footing.scale == walkers_[n].footing.scale;
    const Memory& memory = walker.memory;
    const auto goals = static_cast<std::int32_t>(groups_[traits_[n].group].goals.size());
    is_good = is_good && memory.turn >= -1 && memory.turn <= 1 && memory.goal >= 0 &&
              memory.goal <= std::max(goals - 1, 0);
    if (!is_good)
      refuse(fmt::format("walker {} with numbers out of range", n), "places, unit vectors and shares");
  }
  walkers_ = std::move(walkers);
}

}  // namespace prairie
