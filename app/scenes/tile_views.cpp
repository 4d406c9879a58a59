#include "app/scenes/tile_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "world/camera_placement.h"

namespace prairie {
namespace {

constexpr double kObliquePitchRad = glm::radians(-45.0);
constexpr double kObliqueFovRad = glm::radians(40.0);
constexpr double kEyeDistanceM = 3.0;
constexpr double kEyeFovRad = glm::radians(60.0);
constexpr double kTopClearanceM = 2.0;
constexpr double kLeastGroundClearanceM = 0.5;

void look_at(Camera& camera, glm::dvec3 target_m) {
  const glm::dvec3 way = target_m - camera.eye_m;
  camera.pitch_rad = std::atan2(way.z, std::hypot(way.x, way.y));
}

Camera top(glm::dvec3 middle_m, double tile_m, double highest_m, double aspect) {
  Camera camera;
  camera.eye_m = {middle_m.x, middle_m.y, highest_m + kTopClearanceM};
  camera.pitch_rad = glm::radians(-90.0);
  camera.orthographic_height_m = tile_m / std::min(1.0, aspect);
  return camera;
}

Camera oblique(const Meadow& meadow, glm::dvec3 middle_m, double radius_m, double aspect) {
  Camera camera;
  camera.fov_rad = kObliqueFovRad;
  const double half_width_rad = std::atan(std::tan(kObliqueFovRad / 2.0) * aspect);
  const double distance_m = radius_m / std::sin(std::min(kObliqueFovRad / 2.0, half_width_rad));
  camera.eye_m =
      middle_m + distance_m * glm::dvec3(0.0, -std::cos(kObliquePitchRad), -std::sin(kObliquePitchRad));
  const double ground_m = static_cast<double>(meadow.ground.height_m(glm::dvec2(camera.eye_m)));
  camera.eye_m.z = std::max(camera.eye_m.z, ground_m + kLeastGroundClearanceM);
  look_at(camera, middle_m);
  return camera;
}

Camera eye(const Meadow& meadow, glm::dvec3 middle_m, double tile_m) {
  Camera camera;
  camera.fov_rad = kEyeFovRad;
  const glm::dvec2 place_m{middle_m.x, middle_m.y - tile_m / 2.0 - kEyeDistanceM};
  camera.eye_m = {place_m, static_cast<double>(meadow.ground.height_m(place_m)) + kEyeHeightM};
  look_at(camera, middle_m);
  return camera;
}

}  // namespace

std::string_view tile_view_name(TileView view) {
  switch (view) {
    case TileView::kTop:
      return "top";
    case TileView::kOblique:
      return "oblique";
    case TileView::kEye:
      break;
  }
  return "eye";
}

Camera tile_camera(const Meadow& meadow, double tallest_m, TileId tile, TileView view, glm::ivec2 size_px) {
  const glm::dvec2 origin_m = tile_origin_m(meadow, tile);
  const glm::dvec2 far_m = origin_m + meadow.tile_m;
  const HeightRange ground = meadow.ground.range(origin_m, far_m);
  const double lowest_m = static_cast<double>(ground.min_m);
  const double highest_m = static_cast<double>(ground.max_m) + tallest_m;
  const glm::dvec3 middle_m{(origin_m + far_m) / 2.0, (lowest_m + highest_m) / 2.0};
  const double radius_m = glm::length(glm::dvec3(meadow.tile_m, meadow.tile_m, highest_m - lowest_m)) / 2.0;
  const double aspect = static_cast<double>(size_px.x) / static_cast<double>(size_px.y);
  Camera camera;
  switch (view) {
    case TileView::kTop:
      camera = top(middle_m, meadow.tile_m, highest_m, aspect);
      break;
    case TileView::kOblique:
      camera = oblique(meadow, middle_m, radius_m, aspect);
      break;
    case TileView::kEye:
      camera = eye(meadow, middle_m, meadow.tile_m);
      break;
  }
  camera.size_px = size_px;
  return camera;
}

}  // namespace prairie
