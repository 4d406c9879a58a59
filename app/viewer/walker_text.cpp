#include "app/viewer/walker_text.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "world/world.h"

namespace prairie {
namespace {

const char* kind_name(Percept::Kind kind) {
  switch (kind) {
    case Percept::Kind::kNothing:
      break;
    case Percept::Kind::kObstacle:
      return "obstacle";
    case Percept::Kind::kWalker:
      return "walker";
    case Percept::Kind::kMover:
      return "mover";
  }
  return "nothing";
}

}  // namespace

double angle_to_percept_rad(const Percept& percept, glm::dvec2 forward) {
  const double sine = forward.x * percept.toward.y - forward.y * percept.toward.x;
  return std::atan2(sine, glm::dot(forward, percept.toward));
}

std::string walkers_line(const World& world) {
  const std::size_t count = world.walkers().size();
  if (count == 0) return {};
  std::size_t present = 0;
  for (std::size_t n = 0; n < count; ++n) present += world.is_present(n) ? 1 : 0;
  if (present == count) return fmt::format("{} walkers", fmt::group_digits(count));
  return fmt::format("{} of {} walkers", fmt::group_digits(present), fmt::group_digits(count));
}

std::string watched_walker_line(const World& world, std::size_t walker, std::span<const Percept> percepts) {
  const Walker& watched = world.walkers()[walker];
  std::string line = fmt::format("walker {}: {:.2f} m/s", walker, watched.speed_m_per_s);
  if (world.replayed()) {
    line += "   of a recorded track";
    return world.is_present(walker) ? line : line + ", not there now";
  }
  const Percept& nearest = percepts[walker];
  if (nearest.kind == Percept::Kind::kNothing) {
    line += fmt::format("   nothing within {:.1f} m", world.walker_traits()[walker].sensor_m);
  } else {
    line += fmt::format("   {}: d {:.2f} m, theta {:.0f} deg", kind_name(nearest.kind), nearest.distance_m,
                        glm::degrees(angle_to_percept_rad(nearest, watched.forward)));
  }
  if (world.crowd().is_steered(walker)) return line + "   steered";
  return line + fmt::format("   {}", world.walker_traits()[walker].behaviour->name);
}

}  // namespace prairie
