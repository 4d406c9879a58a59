#include "render/things/mover_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prairie {
namespace {

constexpr glm::vec3 kGranite(0.17f, 0.162f, 0.15f);
constexpr float kStoneRoughness = 0.06f;
constexpr glm::vec3 kBoards(0.25f, 0.18f, 0.115f);
constexpr glm::vec3 kBeams(0.20f, 0.14f, 0.088f);

// The cart, in half widths of its own.
constexpr glm::dvec3 kBoxHalf(1.6, 1.0, 0.45);
constexpr double kBoardHalf = 0.035;  // thickness of the box's boards
constexpr double kWheelRadius = 0.35;
constexpr double kWheelHalf = 0.06;
constexpr double kAxleHalf = 0.05;
constexpr double kBeamHalf = 0.06;
constexpr double kShaftLength = 1.3;

// How far it has come along its path.
double way_m(const Mover& mover, double time_s) {
  const MoverPath& path = mover.path();
  const double way_m = std::max(time_s - path.start_s, 0.0) * path.speed_m_per_s;
  return path.loops ? way_m : std::min(way_m, mover.length_m());
}

DrawnSolid stone(double radius_m, const MoverPlace& place) {
  DrawnSolid solid;
  solid.shape = DrawnSolid::Shape::kSphere;
  solid.centre_m = place.centre_m;
  solid.axes = glm::mat3(place.axes);
  solid.half_size_m = glm::vec3(static_cast<float>(radius_m));
  solid.albedo = kGranite;
  solid.roughness_of_outline = kStoneRoughness;
  return solid;
}

/// The parts of a cart, put together in its own axes, in half widths of it.
class CartParts {
 public:
  CartParts(const MoverPlace& place, double half_width_m, double ground_m, std::vector<DrawnSolid>& parts)
      : place_(place), half_width_m_(half_width_m), ground_m_(ground_m), parts_(parts) {}

  void add(DrawnSolid::Shape shape, glm::dvec3 centre, glm::dvec3 half_size, glm::vec3 albedo,
           const glm::dmat3& turn = glm::dmat3(1.0)) {
    DrawnSolid solid;
    solid.shape = shape;
    solid.centre_m = place_.centre_m + place_.axes * (half_width_m_ * centre);
    solid.axes = glm::mat3(place_.axes * turn);
    solid.half_size_m = glm::vec3(half_width_m_ * half_size);
    solid.albedo = albedo;
    // A wheel stands on the ground, whatever the ground does between the wheels.
    if (shape == DrawnSolid::Shape::kBox)
      solid.above_ground_m =
          static_cast<float>(std::max(solid.centre_m.z - half_width_m_ * half_size.z - ground_m_, 0.0));
    parts_.push_back(solid);
  }

 private:
  const MoverPlace& place_;
  double half_width_m_;
  double ground_m_;
  std::vector<DrawnSolid>& parts_;
};

void add_cart(double half_width_m, const MoverPlace& place, const HeightField& ground, double rolled_m,
              std::vector<DrawnSolid>& solids) {
  const auto ground_m = static_cast<double>(ground.height_m(place.contact_m));
  CartParts cart(place, half_width_m, ground_m, solids);
  using enum DrawnSolid::Shape;

  // An open box: its floor, its long sides, its ends between them.
  const double side = kBoxHalf.y - kBoardHalf, end = kBoxHalf.x - kBoardHalf;
  cart.add(kBox, {0, 0, -kBoxHalf.z + kBoardHalf},
           {kBoxHalf.x - 2 * kBoardHalf, side - kBoardHalf, kBoardHalf}, kBoards);
  for (const double sign : {-1.0, 1.0}) {
    cart.add(kBox, {0, sign * side, 0}, {kBoxHalf.x, kBoardHalf, kBoxHalf.z}, kBoards);
    cart.add(kBox, {sign * end, 0, 0}, {kBoardHalf, side - kBoardHalf, kBoxHalf.z}, kBoards);
    // Posts that hold the boards.
    for (const double along : {-0.62, 0.0, 0.62})
      cart.add(kBox, {along * kBoxHalf.x, sign * (kBoxHalf.y + 0.03), 0}, {0.05, 0.03, kBoxHalf.z}, kBeams);
  }

  // Wheels stand on the plane that touches the ground between them.
  const glm::dvec3 contact_m(place.contact_m, ground_m);
  const double drop = glm::dot(place.centre_m - contact_m, place.axes[2]) / half_width_m;
  const double axle_z = kWheelRadius - drop;
  const double axle_x = kBoxHalf.x - kWheelRadius;
  const double wheel_y = kBoxHalf.y + kWheelHalf + 0.07;
  const double angle = rolled_m / (kWheelRadius * half_width_m);
  const double turn = std::fmod(angle, 2.0 * std::numbers::pi);
  const glm::dmat3 turned(std::cos(turn), 0.0, -std::sin(turn), 0.0, 1.0, 0.0, std::sin(turn), 0.0,
                          std::cos(turn));
  for (const double along : {-axle_x, axle_x}) {
    cart.add(kBox, {along, 0, axle_z}, {kAxleHalf, wheel_y - kWheelHalf, kAxleHalf}, kBeams);
    // What rests on the axle and bears the box.
    const double above = 0.5 * (axle_z + kAxleHalf - kBoxHalf.z),
                 half = 0.5 * (-kBoxHalf.z - axle_z - kAxleHalf);
    if (half > 0.0) cart.add(kBox, {along, 0, above}, {1.2 * kAxleHalf, 0.7, half}, kBeams);
    for (const double across : {-wheel_y, wheel_y})
      cart.add(kWheel, {along, across, axle_z}, {kWheelRadius, kWheelHalf, kWheelRadius}, kBeams, turned);
  }
  // Two shafts for what draws it.
  for (const double sign : {-1.0, 1.0})
    cart.add(kBox, {kBoxHalf.x + 0.5 * kShaftLength - 0.2, sign * 0.55, -kBoxHalf.z - kBeamHalf},
             {0.5 * kShaftLength + 0.2, 0.7 * kBeamHalf, kBeamHalf}, kBeams);
}

}  // namespace

std::vector<DrawnSolid> drawn_movers(const World& world) {
  std::vector<DrawnSolid> solids;
  const HeightField& ground = world.meadow().ground;
  const auto add = [&](MoverKind kind, double radius_m, const MoverPlace& place, double rolled_m) {
    switch (kind) {
      case MoverKind::kStone:
        solids.push_back(stone(radius_m, place));
        break;
      case MoverKind::kCart:
        add_cart(radius_m, place, ground, rolled_m, solids);
        break;
    }
  };
  for (const Mover& mover : world.movers()) {
    add(mover.path().kind, mover.path().radius_m, mover.place(ground, world.time_s()),
        way_m(mover, world.time_s()));
  }
  for (const DrivenMover& driven : world.driven())
    add(driven.kind, driven.radius_m, driven.place, driven.rolled_m);
  for (std::size_t n = 0; n < solids.size(); ++n) solids[n].seed = static_cast<std::uint32_t>(n);
  return solids;
}

}  // namespace prairie
