#include "world/camera_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prairie {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;
constexpr int kDirections = 16;
constexpr double kLongestViewM = 120.0;
constexpr double kGoodViewM = 60.0;     // a place with this much meadow ahead is good enough,
constexpr double kGoodViewShare = 0.3;  // or, in small scenes, with this share of their size
constexpr double kStandM = 0.75;        // the ground is planted this far around the feet
constexpr double kLookAheadM = 18.0;    // the ground at this distance is in the middle of the picture
constexpr int kCoarseRings = 20;
constexpr int kFineRings = 80;  // for scenes where grass grows in few places

glm::dvec2 heading(double yaw_deg) {
  const double yaw_rad = yaw_deg / kDegPerRad;
  return {std::sin(yaw_rad), std::cos(yaw_rad)};
}

bool is_standing_place(const Meadow& meadow, glm::dvec2 position_m) {
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      if (!is_planted(meadow, position_m + kStandM * glm::dvec2(i, j))) return false;
    }
  }
  return true;
}

double planted_stretch_m(const Meadow& meadow, glm::dvec2 from_m, double yaw_deg, double step_m) {
  const glm::dvec2 direction = heading(yaw_deg);
  double stretch_m = 0.0;
  while (stretch_m < kLongestViewM && is_planted(meadow, from_m + (stretch_m + step_m) * direction)) {
    stretch_m += step_m;
  }
  return stretch_m;
}

struct View {
  glm::dvec2 position_m{0.0};
  double yaw_deg = 0.0;
  double stretch_m = -1.0;
};

View longest_view(const Meadow& meadow, glm::dvec2 position_m) {
  View best;
  for (int k = 0; k < kDirections; ++k) {
    const double yaw_deg = 360.0 * k / kDirections;
    const double stretch_m = planted_stretch_m(meadow, position_m, yaw_deg, 1.0);
    if (stretch_m > best.stretch_m) best = {position_m, yaw_deg, stretch_m};
  }
  return best;
}

// Square rings around the middle of the scene, the nearest first.
View best_view(const Meadow& meadow, int rings) {
  const glm::dvec2 middle_m = 0.5 * meadow.extent_m;
  const glm::dvec2 step_m = 0.5 / rings * meadow.extent_m;
  const double good_view_m =
      std::min(kGoodViewM, kGoodViewShare * std::min(meadow.extent_m.x, meadow.extent_m.y));
  View best;
  for (int ring = 0; ring < rings; ++ring) {
    for (int j = -ring; j <= ring; ++j) {
      const bool is_end_row = std::abs(j) == ring;
      for (int i = -ring; i <= ring; i += is_end_row || ring == 0 ? 1 : 2 * ring) {
        const glm::dvec2 position_m = middle_m + step_m * glm::dvec2(i, j);
        if (!is_standing_place(meadow, position_m)) continue;
        const View view = longest_view(meadow, position_m);
        if (view.stretch_m > best.stretch_m) best = view;
        if (best.stretch_m >= good_view_m) return best;
      }
    }
  }
  return best;
}

}  // namespace

bool is_planted(const Meadow& meadow, glm::dvec2 position_m) {
  const bool is_inside =
      meadow.repeats || (position_m.x >= 0.0 && position_m.y >= 0.0 && position_m.x <= meadow.extent_m.x &&
                         position_m.y <= meadow.extent_m.y);
  if (!is_inside || !meadow.ground.has_data(position_m, position_m)) return false;
  return std::any_of(meadow.species.begin(), meadow.species.end(), [&](const PlantedSpecies& planted) {
    return planted.density_per_m2.sample(position_m) > 0.0f;  // false for NaN
  });
}

double pitch_to_ground_deg(const Meadow& meadow, glm::dvec2 position_m, double yaw_deg, double eye_height_m,
                           double distance_m) {
  const double here_m = static_cast<double>(meadow.ground.height_m(position_m)) + eye_height_m;
  const double there_m =
      static_cast<double>(meadow.ground.height_m(position_m + distance_m * heading(yaw_deg)));
  return std::atan2(there_m - here_m, distance_m) * kDegPerRad;
}

CameraSpec placed_camera_spec(const Meadow& meadow, const std::string& name) {
  View view = best_view(meadow, kCoarseRings);
  if (view.stretch_m < 0.0) view = best_view(meadow, kFineRings);
  if (view.stretch_m < 0.0) view.position_m = 0.5 * meadow.extent_m;
  CameraSpec camera;
  camera.name = name;
  camera.position_m = view.position_m;
  camera.z_m = kEyeHeightM;
  camera.z_above_ground = true;
  camera.yaw_deg = view.yaw_deg;
  const double pitch_deg =
      pitch_to_ground_deg(meadow, view.position_m, view.yaw_deg, kEyeHeightM, kLookAheadM);
  camera.pitch_deg = std::clamp(pitch_deg, -25.0, 15.0);
  return camera;
}

}  // namespace prairie
