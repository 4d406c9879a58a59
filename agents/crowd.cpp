#include "agents/crowd.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "agents/foot_treads.h"
#include "agents/free_step.h"
#include "agents/plan_cell.h"
#include "agents/plane_vectors.h"
#include "agents/skeleton.h"
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
constexpr double kNoiseKnotS = 0.8;                            // between independent values of the noise
constexpr std::size_t kMostLimits = 24, kMostFirmLimits = 20;  // the others are for movers
constexpr int kMostTries = 400;                                // to find room for a walker
constexpr double kApartM = 0.05;                               // at the start
constexpr double kStandsBelow = 1e-3;                          // m/s

enum class Purpose : std::uint32_t { kStart = 0x77616c6bu, kSpeedNoise, kHeadingNoise, kWander, kTraits };

std::array<double, 3> units(std::uint32_t seed, std::uint32_t walker, Purpose purpose, std::uint32_t n) {
  Kernels kernels;
  const glm::uvec3 words =
      kernels.hash_uvec3(glm::uvec3(seed ^ kernels.hash_u32(static_cast<std::uint32_t>(purpose)), walker, n));
  return {static_cast<double>(kernels.unit_from_u32(words.x)),
          static_cast<double>(kernels.unit_from_u32(words.y)),
          static_cast<double>(kernels.unit_from_u32(words.z))};
}

/// Gaussian but for its tails, which end at ±6: the sum of twelve uniform numbers.
double gaussian(std::uint32_t seed, std::uint32_t walker, Purpose purpose, std::uint32_t n) {
  Kernels kernels;
  double sum = 0.0;
  for (std::uint32_t part = 0; part < 2; ++part) {
    const glm::uvec3 words = kernels.hash_uvec3(
        glm::uvec3(seed ^ kernels.hash_u32(static_cast<std::uint32_t>(purpose)), walker, 2 * n + part));
    for (const std::uint32_t word : {words.x, words.y, words.z})
      sum += static_cast<double>(kernels.unit_from_low16(word)) +
             static_cast<double>(kernels.unit_from_high16(word));
  }
  return sum - 6.0 + 12.0 * 0.5 / 65536.0;
}

/// Of mean 0 and deviation 1 at all times, smooth in time.
double noise_at(std::uint32_t seed, std::uint32_t walker, Purpose purpose, double time_s) {
  const double knots = time_s / kNoiseKnotS, knot = std::floor(knots), t = knots - knot;
  const auto n = static_cast<std::uint32_t>(static_cast<std::int64_t>(knot));
  const double a = 1.0 - t, b = t;
  return (a * gaussian(seed, walker, purpose, n) + b * gaussian(seed, walker, purpose, n + 1)) /
         std::sqrt(a * a + b * b);
}

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

PlanDistance between(const Disc& from, const Disc& to) {
  const glm::dvec2 way = to.centre_m - from.centre_m;
  return {glm::length(way) - from.radius_m - to.radius_m, unit(way, {1.0, 0.0})};
}

bool is_beyond(const FootprintBox& box, glm::dvec2 position_m, double reach_m) {
  const glm::dvec2 apart =
      glm::max(glm::max(box.low_m - position_m, position_m - box.high_m), glm::dvec2(0.0));
  return glm::dot(apart, apart) > reach_m * reach_m;
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
  constexpr double kCellM = 2.0;  // at least as wide as two bodies
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> placed;
  std::size_t total = 0;
  for (const WalkerGroup& group : groups) total += group.count;
  if (total > kMostWalkers)
    throw BadInput("", "count", fmt::format("{} walkers", total),
                   fmt::format("at most {} in all", kMostWalkers));

  // What is in the way of a body, if anything.
  const auto obstruction = [&](const Disc& body, double apart_m) -> const char* {
    for (const std::uint32_t n : obstacles_.near(body.centre_m)) {
      if (is_beyond(obstacles_.box(n), body.centre_m, body.radius_m + apart_m)) continue;
      if (plan_distance(body, obstacles_.footprints()[n]).distance_m < apart_m)
        return "inside of an obstacle or beyond a wall";
    }
    const PlanCell here = plan_cell(body.centre_m, kCellM);
    for (int j = here.j - 1; j <= here.j + 1; ++j) {
      for (int i = here.i - 1; i <= here.i + 1; ++i) {
        const auto cell = placed.find(key_of({i, j}));
        if (cell == placed.end()) continue;
        for (const std::uint32_t other : cell->second) {
          const Disc there{walkers_[other].position_m, traits_[other].radius_m};
          if (between(body, there).distance_m < apart_m) return "on the place of another walker";
        }
      }
    }
    return nullptr;
  };

  for (std::size_t g = 0; g < groups.size(); ++g) {
    const WalkerGroup& group = groups[g];
    check(group);
    groups_.push_back({group.goals});
    for (std::uint32_t n = 0; n < group.count; ++n) {
      const auto id = static_cast<std::uint32_t>(walkers_.size());
      const auto spread = [](double unit_share, double most) {
        return 1.0 + most * (2.0 * unit_share - 1.0);
      };
      const std::array<double, 3> own = units(seed_, id, Purpose::kTraits, 0);
      WalkerTraits traits;
      traits.group = static_cast<std::uint32_t>(g);
      traits.id = id;
      traits.height_m = group.height_m * spread(own[0], group.height_spread);
      traits.radius_m = group.body_radius_m * traits.height_m / kFigureHeightM;
      traits.speed_m_per_s = group.speed_m_per_s * spread(own[1], group.speed_spread);
      traits.sensor_m = group.sensor_m;
      traits.noise = group.noise;
      traits.behaviour = find_behaviour(group.behaviour);

      Walker walker;
      walker.forward = unit(direction_of(6.283185307179586 * own[2]), {1.0, 0.0});
      if (!group.starts_m.empty()) {
        walker.position_m = group.starts_m[n];
        if (const char* fault = obstruction({walker.position_m, traits.radius_m}, 0.0); fault != nullptr) {
          throw BadInput(
              "", "starts_m",
              fmt::format("walker {} {} ([{}, {}])", n, fault, walker.position_m.x, walker.position_m.y),
              "a free place");
        }
      } else {
        bool has_room = false;
        for (int attempt = 0; attempt < kMostTries && !has_room; ++attempt) {
          const std::array<double, 3> dart =
              units(seed_, id, Purpose::kStart, static_cast<std::uint32_t>(attempt));
          walker.position_m = group.centre_m +
                              group.radius_m * std::sqrt(dart[0]) * direction_of(6.283185307179586 * dart[1]);
          has_room = obstruction({walker.position_m, traits.radius_m}, kApartM) == nullptr;
        }
        if (!has_room) {
          throw BadInput("", "radius_m", fmt::format("no room for walker {} of {}", n + 1, group.count),
                         "a wider disc, or one with fewer obstacles");
        }
      }
      traits.home_m = walker.position_m;
      walker.footing = standing(walker.position_m, walker.forward, traits.height_m / kFigureHeightM);
      placed[key_of(plan_cell(walker.position_m, kCellM))].push_back(id);
      traits_.push_back(traits);
      walkers_.push_back(walker);
    }
  }
  steered_.resize(walkers_.size());
}

Percept Crowd::perceived(std::size_t index, const Neighbours& neighbours,
                         std::span<const Footprint> movers) const {
  const WalkerTraits& traits = traits_[index];
  const Disc body{walkers_[index].position_m, traits.radius_m};
  Percept nearest{Percept::Kind::kNothing, traits.sensor_m, walkers_[index].forward};
  neighbours.for_near(body.centre_m, [&](std::uint32_t other, const Disc& there) {
    if (other != index) nearer(between(body, there), Percept::Kind::kWalker, nearest);
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
  sight.turn_noise = noise_at(seed_, traits.id, Purpose::kWander, 0.5 * time_s);
  sight.goals = groups_[traits.group].goals;
  MotorCommand command = traits.behaviour->decide(sight, memory);
  const double sigma = noise_deviation(traits.noise, nearest.distance_m, traits.sensor_m);
  command.speed_m_per_s *=
      std::max(1.0 + sigma * noise_at(seed_, traits.id, Purpose::kSpeedNoise, time_s), 0.0);
  const double aside = sigma * noise_at(seed_, traits.id, Purpose::kHeadingNoise, time_s);
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
      const PlanDistance found = between(body, there);
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
