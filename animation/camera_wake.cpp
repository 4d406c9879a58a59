#include "animation/camera_wake.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "animation/range_check.h"
#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

void check(const char* field, double value, double low, double high) {
  check_range(std::string("camera wake: ") + field, value, low, high);
}

void check_place(glm::dvec2 camera_m) {
  check("camera_m", camera_m.x, -1e7, 1e7);
  check("camera_m", camera_m.y, -1e7, 1e7);
}

CameraWakeSettings checked(const CameraWakeSettings& settings) {
  check("nodes", settings.nodes, 3, 257);
  if (settings.nodes % 2 == 0)
    throw BadInput("", "camera wake: nodes", fmt::format("{}", settings.nodes), "an odd number");
  check("spacing_m", settings.spacing_m, 0.1, 10.0);
  check("damping_per_s", settings.damping_per_s, 0.01, 100.0);
  check("stirring_per_s", settings.stirring_per_s, 0.0, 100.0);
  check("spread_m", settings.spread_m, 0.1, 1000.0);
  check("most_m_per_s", settings.most_m_per_s, 0.0, 100.0);
  return settings;
}

NodeIndex corner_around(glm::dvec2 camera_m, const CameraWakeSettings& settings) {
  const NodeIndex nearest = square_of(camera_m + 0.5 * settings.spacing_m, settings.spacing_m).south_west;
  return {nearest.i - settings.nodes / 2, nearest.j - settings.nodes / 2};
}

}  // namespace

CameraWake::CameraWake(const CameraWakeSettings& settings) : settings_(checked(settings)) {
  state_.velocities_m_per_s.resize(static_cast<std::size_t>(settings.nodes) *
                                   static_cast<std::size_t>(settings.nodes));
}

void CameraWake::restore(CameraWakeState state) {
  if (state.velocities_m_per_s.size() != state_.velocities_m_per_s.size()) {
    throw BadInput("", "camera wake: velocities_m_per_s", fmt::format("{}", state.velocities_m_per_s.size()),
                   fmt::format("{} of them", state_.velocities_m_per_s.size()));
  }
  check("time_s", state.time_s, -1e12, 1e12);
  check_place(state.camera_m);
  check("south_west", state.south_west.i, -1e9, 1e9);
  check("south_west", state.south_west.j, -1e9, 1e9);
  for (const glm::vec2& velocity : state.velocities_m_per_s) {
    check("velocities_m_per_s", static_cast<double>(velocity.x), -1e3, 1e3);
    check("velocities_m_per_s", static_cast<double>(velocity.y), -1e3, 1e3);
  }
  state_ = std::move(state);
}

void CameraWake::step(glm::dvec2 camera_m, double to_s) {
  check_place(camera_m);
  const double dt_s = state_.placed ? to_s - state_.time_s : 0.0;
  if (!std::isfinite(to_s) || dt_s < 0.0) {
    throw BadInput("", "camera wake: time_s", fmt::format("{}", to_s),
                   fmt::format("{} or later", state_.time_s));
  }
  const glm::dvec2 moved_m = state_.placed ? camera_m - state_.camera_m : glm::dvec2(0.0);
  const double way_m = glm::length(moved_m);
  const bool jumped = way_m > settings_.nodes * settings_.spacing_m;

  // Velocities stay at their places.
  const NodeIndex corner = corner_around(camera_m, settings_);
  std::vector<glm::vec2> velocities(state_.velocities_m_per_s.size());
  const double lambda = settings_.damping_per_s;
  const float kept = Kernels{}.falling_exponential(static_cast<float>(lambda * dt_s));
  const double gained_s = static_cast<double>(1.0f - kept) / lambda;
  const double stirring = dt_s > 0.0 && !jumped ? settings_.stirring_per_s * way_m / dt_s : 0.0;
  const glm::dvec2 motion = way_m > 0.0 ? moved_m / way_m : glm::dvec2(0.0);
  const double middle2 = 0.25 * settings_.spacing_m * settings_.spacing_m;
  const float most = static_cast<float>(settings_.most_m_per_s);
  for (int row = 0; row < settings_.nodes; ++row) {
    for (int column = 0; column < settings_.nodes; ++column) {
      const NodeIndex node{corner.i + column, corner.j + row};
      glm::vec2 velocity = at(node) * kept;
      // From the middle of the camera's way.
      const glm::dvec2 from_m = glm::dvec2(node.i, node.j) * settings_.spacing_m - (camera_m - 0.5 * moved_m);
      const double share = 1.0 - glm::dot(from_m, from_m) / (settings_.spread_m * settings_.spread_m);
      if (stirring > 0.0 && share > 0.0) {
        const glm::dvec2 away = from_m / std::sqrt(glm::dot(from_m, from_m) + middle2);
        const double a = stirring * share * share * std::max(glm::dot(away, motion), 0.0);
        velocity += glm::vec2(away * (a * gained_s));
      }
      const float speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
      if (speed > most) velocity *= most / speed;
      velocities[static_cast<std::size_t>(row * settings_.nodes + column)] = velocity;
    }
  }
  state_ = {to_s, true, camera_m, corner, std::move(velocities)};
}

glm::vec2 CameraWake::at(NodeIndex node) const {
  const int column = node.i - state_.south_west.i, row = node.j - state_.south_west.j;
  if (!state_.placed || column < 0 || row < 0 || column >= settings_.nodes || row >= settings_.nodes) {
    return glm::vec2(0.0f);
  }
  return state_.velocities_m_per_s[static_cast<std::size_t>(row * settings_.nodes + column)];
}

glm::vec2 CameraWake::velocity_m_per_s(glm::dvec2 position_m) const {
  const auto [corner, east, north] = square_of(position_m, settings_.spacing_m);
  const glm::vec2 south = at(corner) * (1.0f - east) + at({corner.i + 1, corner.j}) * east;
  const glm::vec2 norths =
      at({corner.i, corner.j + 1}) * (1.0f - east) + at({corner.i + 1, corner.j + 1}) * east;
  return south * (1.0f - north) + norths * north;
}

}  // namespace prairie
