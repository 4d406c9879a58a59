#include "app/viewer/walker_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "world/world.h"

namespace prairie {
namespace {

constexpr glm::vec4 kSensorColor(0.75f, 0.02f, 0.01f, 0.75f);
constexpr glm::vec4 kObstacleColor(1.0f, 0.03f, 0.02f, 1.0f);
constexpr glm::vec4 kPathColor(0.03f, 0.25f, 0.9f, 0.9f);
constexpr float kOldestShown = 0.1f;
constexpr double kLongestPieceM = 1.0;  // of a line that follows the ground

glm::dvec3 over_ground_m(const HeightField& ground, glm::dvec2 place_m) {
  return {place_m, static_cast<double>(ground.height_m(place_m)) + kLineAboveGroundM};
}

void add_line(const HeightField& ground, glm::dvec2 from_m, glm::dvec2 to_m, glm::vec4 color,
              std::vector<LineSegment>& lines) {
  const int pieces = std::max(static_cast<int>(std::ceil(glm::distance(from_m, to_m) / kLongestPieceM)), 1);
  glm::dvec3 last_m = over_ground_m(ground, from_m);
  for (int n = 1; n <= pieces; ++n) {
    const glm::dvec3 next_m = over_ground_m(ground, glm::mix(from_m, to_m, static_cast<double>(n) / pieces));
    lines.push_back({last_m, next_m, color});
    last_m = next_m;
  }
}

using CircleDirections = std::array<glm::dvec2, kCircleSegments>;

CircleDirections circle_directions() {
  CircleDirections directions;
  for (std::size_t n = 0; n < kCircleSegments; ++n) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(n) / kCircleSegments;
    directions[n] = {std::cos(angle_rad), std::sin(angle_rad)};
  }
  return directions;
}

void add_circle(const HeightField& ground, glm::dvec2 centre_m, double radius_m,
                const CircleDirections& directions, std::vector<LineSegment>& lines) {
  glm::dvec3 last_m = over_ground_m(ground, centre_m + radius_m * directions.back());
  for (const glm::dvec2 direction : directions) {
    const glm::dvec3 next_m = over_ground_m(ground, centre_m + radius_m * direction);
    lines.push_back({last_m, next_m, kSensorColor});
    last_m = next_m;
  }
}

glm::vec4 path_color(double age_s) {
  const auto share = static_cast<float>(std::clamp(age_s / WalkerTrails::kLengthS, 0.0, 1.0));
  glm::vec4 color = kPathColor;
  color.w *= glm::mix(1.0f, kOldestShown, share);
  return color;
}

/// Pieces of the paths of those shown who are in both samples. A walker is never far from its last sample:
/// pieces are straight.
void add_pieces(std::span<const WalkerTrails::Place> from, std::span<const WalkerTrails::Place> to,
                glm::vec4 color, std::span<const std::uint32_t> shown, std::vector<LineSegment>& lines) {
  constexpr glm::dvec3 kAbove(0.0, 0.0, kLineAboveGroundM);
  auto before = from.begin();
  auto chosen = shown.begin();
  for (const WalkerTrails::Place& place : to) {
    while (before != from.end() && before->walker < place.walker) ++before;
    while (chosen != shown.end() && *chosen < place.walker) ++chosen;
    if (before == from.end() || chosen == shown.end()) return;
    if (before->walker != place.walker || *chosen != place.walker || *before == place) continue;
    lines.push_back({before->on_ground_m + kAbove, place.on_ground_m + kAbove, color});
  }
}

}  // namespace

const char* walker_overlay_name(WalkerOverlay overlay) {
  switch (overlay) {
    case WalkerOverlay::kNone:
      break;
    case WalkerOverlay::kSensors:
      return "sensors";
    case WalkerOverlay::kPaths:
      return "paths";
    case WalkerOverlay::kBoth:
      return "sensors and paths";
  }
  return "none";
}

WalkerOverlay next_walker_overlay(WalkerOverlay overlay) {
  switch (overlay) {
    case WalkerOverlay::kNone:
      return WalkerOverlay::kSensors;
    case WalkerOverlay::kSensors:
      return WalkerOverlay::kPaths;
    case WalkerOverlay::kPaths:
      return WalkerOverlay::kBoth;
    case WalkerOverlay::kBoth:
      break;
  }
  return WalkerOverlay::kNone;
}

bool shows_sensors(WalkerOverlay overlay) {
  return overlay == WalkerOverlay::kSensors || overlay == WalkerOverlay::kBoth;
}

bool shows_paths(WalkerOverlay overlay) {
  return overlay == WalkerOverlay::kPaths || overlay == WalkerOverlay::kBoth;
}

std::vector<LineSegment> sensor_lines(const World& world, std::span<const Percept> percepts,
                                      glm::dvec3 eye_m) {
  std::vector<LineSegment> lines;
  if (percepts.empty()) return lines;
  const HeightField& ground = world.meadow().ground;
  const CircleDirections directions = circle_directions();
  for (const std::uint32_t n : nearest_walkers(world, eye_m, kMostOverlaidWalkers)) {
    const glm::dvec2 place_m = world.walkers()[n].position_m;
    const WalkerTraits& traits = world.walker_traits()[n];
    const Percept& nearest = percepts[n];
    add_circle(ground, place_m, traits.radius_m + traits.sensor_m, directions, lines);
    if (nearest.kind == Percept::Kind::kNothing) continue;
    const glm::dvec2 edge_m = place_m + traits.radius_m * nearest.toward;
    add_line(ground, edge_m, edge_m + nearest.distance_m * nearest.toward, kObstacleColor, lines);
  }
  return lines;
}

std::vector<LineSegment> path_lines(const World& world, const WalkerTrails& trails, glm::dvec3 eye_m) {
  std::vector<LineSegment> lines;
  const std::vector<std::uint32_t> shown = nearest_walkers(world, eye_m, kMostOverlaidWalkers);
  const WalkerTrails::Sample* last = nullptr;
  for (const WalkerTrails::Sample& sample : trails.samples()) {
    const glm::vec4 color = path_color(world.time_s() - sample.time_s);
    if (last != nullptr) add_pieces(last->places, sample.places, color, shown, lines);
    last = &sample;
  }
  if (last == nullptr) return lines;
  std::vector<WalkerTrails::Place> now;
  for (const std::uint32_t n : shown) now.push_back({n, on_ground_m(world, n)});
  add_pieces(last->places, now, path_color(0.0), shown, lines);
  return lines;
}

}  // namespace prairie
