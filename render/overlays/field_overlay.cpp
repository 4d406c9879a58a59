#include "render/overlays/field_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr double kArrowLatticeM = 2.0;
constexpr double kArrowAboveM = 0.3;
constexpr float kLeastArrowSpeed = 0.05f;  // m/s; slower air shows none
constexpr float kArrowMPerSpeed = 0.16f;
constexpr float kLeastArrowM = 0.3f, kLongestArrowM = 1.8f;
constexpr double kHeatNodeM = 0.25;
constexpr double kHeatAboveM = 0.06;  // clear of the coarser mesh that is drawn as the ground

float arrow_m(float speed) {
  return std::clamp(kArrowMPerSpeed * speed, kLeastArrowM, kLongestArrowM);
}

float left_to_rise(const Treading& treading, NodeIndex index) {
  const TreadNode node = treading.state().nodes.at(index);
  if (node.field <= 0.0f || node.recovery_s <= 0.0f) return 0.0f;
  const double passed = (treading.state().time_s - node.start_s) / static_cast<double>(node.recovery_s);
  return static_cast<float>(std::clamp(1.0 - passed, 0.0, 1.0));
}

/// Heat and wear at nodes of about kHeatNodeM, each the most of the tread nodes that it stands for.
struct HeatNodes {
  int side = 0;
  double spacing_m = 0.0;
  glm::dvec2 corner_m{0.0};
  std::vector<glm::vec2> values;

  glm::vec2 at(int column, int row) const { return values[static_cast<std::size_t>(row * side + column)]; }
};

HeatNodes heat_nodes(const Treading& treading, glm::dvec2 eye_m, FieldOverlay overlay) {
  const TreadSettings& settings = treading.settings();
  const int stride = std::max(static_cast<int>(std::lround(kHeatNodeM / settings.spacing_m)), 1);
  HeatNodes nodes;
  nodes.spacing_m = stride * settings.spacing_m;
  const int reach = static_cast<int>(std::ceil(kHeatReachM / nodes.spacing_m));
  nodes.side = 2 * reach + 1;
  const NodeIndex middle = square_of(eye_m, nodes.spacing_m).south_west;
  const NodeRect rect{(middle.i - reach) * stride, (middle.j - reach) * stride, nodes.side * stride,
                      nodes.side * stride};
  nodes.corner_m = settings.spacing_m * (glm::dvec2(rect.column, rect.row) + 0.5 * (stride - 1));
  std::vector<glm::vec4> treads(static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  treading.read(rect, treads);
  nodes.values.resize(static_cast<std::size_t>(nodes.side) * static_cast<std::size_t>(nodes.side));
  for (int row = 0; row < rect.rows; ++row) {
    for (int column = 0; column < rect.columns; ++column) {
      const glm::vec4 tread = treads[static_cast<std::size_t>(row * rect.columns + column)];
      if (tread.z == 0.0f && tread.w == 0.0f) continue;
      const float heat = overlay == FieldOverlay::kTilt
                             ? tread.z / settings.most_tilt_rad
                             : left_to_rise(treading, {rect.column + column, rect.row + row});
      glm::vec2& value = nodes.values[static_cast<std::size_t>(row / stride * nodes.side + column / stride)];
      value = glm::max(value, glm::vec2(heat, tread.w));
    }
  }
  return nodes;
}

}  // namespace

std::vector<WindArrow> wind_arrows(const World& world, glm::dvec3 eye_m) {
  const int side = 2 * static_cast<int>(kWindArrowsReachM / kArrowLatticeM) + 1;
  const WindNodes nodes = wind_nodes_around(glm::dvec2(eye_m), side, kArrowLatticeM);
  std::vector<glm::vec2> velocities(static_cast<std::size_t>(side * side));
  fill_wind(world.motion().wind(), nodes, world.time_s(), velocities);
  const HeightField& ground = world.meadow().ground;
  std::vector<WindArrow> arrows;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::vec2 velocity = velocities[static_cast<std::size_t>(row * side + column)];
      const float speed = glm::length(velocity);
      const glm::dvec2 place_m =
          kArrowLatticeM * glm::dvec2(nodes.south_west.i + column, nodes.south_west.j + row);
      if (!(speed > kLeastArrowSpeed) || glm::distance(place_m, glm::dvec2(eye_m)) > kWindArrowsReachM)
        continue;
      const glm::dvec3 middle_m(place_m, static_cast<double>(ground.height_m(place_m)) + kArrowAboveM);
      WindArrow arrow{};
      arrow.middle_from_eye_m = glm::vec3(middle_m - eye_m);
      arrow.speed_m_per_s = speed;
      arrow.along_m = velocity * (arrow_m(speed) / speed);
      arrow.slope = ground.slope(place_m);
      arrows.push_back(arrow);
    }
  }
  return arrows;
}

std::vector<HeatSquare> heat_squares(const World& world, glm::dvec3 eye_m, FieldOverlay overlay) {
  const Treading& treading = world.motion().treading();
  std::vector<HeatSquare> squares;
  if (treading.bytes() == 0) return squares;
  const HeatNodes nodes = heat_nodes(treading, glm::dvec2(eye_m), overlay);
  const HeightField& ground = world.meadow().ground;
  for (int row = 0; row + 1 < nodes.side; ++row) {
    for (int column = 0; column + 1 < nodes.side; ++column) {
      HeatSquare square{};
      for (int n = 0; n < 4; ++n) {
        const glm::vec2 value = nodes.at(column + n % 2, row + n / 2);
        square.heat[n] = value.x;
        square.wear += 0.25f * value.y;
      }
      if (square.heat == glm::vec4(0.0f) && square.wear == 0.0f) continue;
      const glm::dvec2 corner_m = nodes.corner_m + nodes.spacing_m * glm::dvec2(column, row);
      if (glm::distance(corner_m, glm::dvec2(eye_m)) > kHeatReachM) continue;
      square.corner_from_eye_m = glm::vec2(corner_m - glm::dvec2(eye_m));
      square.side_m = static_cast<float>(nodes.spacing_m);
      for (int n = 0; n < 4; ++n) {
        const glm::dvec2 at_m = corner_m + nodes.spacing_m * glm::dvec2(n % 2, n / 2);
        square.heights_from_eye_m[n] =
            static_cast<float>(static_cast<double>(ground.height_m(at_m)) + kHeatAboveM - eye_m.z);
      }
      squares.push_back(square);
    }
  }
  return squares;
}

}  // namespace prairie
