#include "agents/obstacle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "animation/heading.h"
#include "animation/range_check.h"
#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr double kFarthestM = 1e6;
constexpr std::uint32_t kRockPoints = 72;
constexpr double kSunk = 0.33;  // share of a rock's height that is in the ground

void check_place(glm::dvec2 position_m) {
  check_range("position_m", position_m.x, -kFarthestM, kFarthestM);
  check_range("position_m", position_m.y, -kFarthestM, kFarthestM);
}

void check_size(glm::dvec3 size_m, double least_m, double most_m) {
  for (const double size : {size_m.x, size_m.y, size_m.z}) check_range("size_m", size, least_m, most_m);
}

struct Check {
  void operator()(const Trunk& trunk) const {
    check_place(trunk.position_m);
    check_range("radius_m", trunk.radius_m, 0.02, 5.0);
    check_range("height_m", trunk.height_m, 0.1, 100.0);
  }
  void operator()(const Block& block) const {
    check_place(block.position_m);
    check_size(block.size_m, 0.02, 1000.0);
    check_range("heading_rad", block.heading_rad, -1e3, 1e3);
  }
  void operator()(const Rock& rock) const {
    check_place(rock.position_m);
    check_size(rock.size_m, 0.05, 50.0);
    check_range("heading_rad", rock.heading_rad, -1e3, 1e3);
  }
};

/// Unit columns ahead, across, up of what stands upright.
glm::dmat3 upright(double heading_rad) {
  const glm::dvec2 rough = direction_of(heading_rad);
  const glm::dvec2 ahead = rough / std::sqrt(rough.x * rough.x + rough.y * rough.y);
  return {glm::dvec3(ahead, 0.0), glm::dvec3(-ahead.y, ahead.x, 0.0), glm::dvec3(0.0, 0.0, 1.0)};
}

std::array<glm::dvec2, 4> corners_of(const Block& block) {
  const glm::dmat3 axes = upright(block.heading_rad);
  const glm::dvec2 ahead = 0.5 * block.size_m.x * glm::dvec2(axes[0]),
                   across = 0.5 * block.size_m.y * glm::dvec2(axes[1]);
  const glm::dvec2 p = block.position_m;
  return {p - ahead - across, p + ahead - across, p + ahead + across, p - ahead + across};
}

}  // namespace

void check(const Obstacle& obstacle) {
  std::visit(Check{}, obstacle);
}

void check(const Wall& wall) {
  check_range("height_m", wall.height_m, 0.0, 100.0);
  convex_pieces(wall.outline);
}

PlacedBlock placed(const Block& block, const HeightField& ground) {
  double lowest_m = static_cast<double>(ground.height_m(block.position_m));
  for (const glm::dvec2 corner_m : corners_of(block))
    lowest_m = std::min(lowest_m, static_cast<double>(ground.height_m(corner_m)));
  return {glm::dvec3(block.position_m, lowest_m + 0.5 * block.size_m.z), upright(block.heading_rad),
          0.5 * block.size_m};
}

// Directions by the golden angle, so that no side is bare; radii vary, which makes edges and faces of all
// sizes.
ConvexHull hull_of(const Rock& rock) {
  std::vector<glm::dvec3> points_m;
  for (std::uint32_t n = 0; n < kRockPoints; ++n) {
    const glm::uvec3 words = Kernels{}.hash_uvec3(glm::uvec3(rock.seed, n, 0x726f636bu));
    const double z = 1.0 - 2.0 * (n + 0.5) / kRockPoints;
    const double across = std::sqrt(1.0 - z * z);
    const glm::dvec2 around =
        direction_of(2.399963229728653 * n + 0.6 * static_cast<double>(Kernels{}.unit_from_u32(words.x)));
    const double out = 0.72 + 0.28 * static_cast<double>(Kernels{}.unit_from_u32(words.y));
    const glm::dvec3 unit(across * around.x, across * around.y, z);
    points_m.push_back(0.5 * out * rock.size_m * unit + glm::dvec3(0.0, 0.0, (0.5 - kSunk) * rock.size_m.z));
  }
  return convex_hull(points_m);
}

RockFrame placed(const Rock& rock, const HeightField& ground) {
  return {glm::dvec3(rock.position_m, static_cast<double>(ground.height_m(rock.position_m))),
          upright(rock.heading_rad)};
}

Footprint footprint_of(const Obstacle& obstacle, const HeightField& ground) {
  if (const auto* trunk = std::get_if<Trunk>(&obstacle)) return Disc{trunk->position_m, trunk->radius_m};
  Outline outline;
  if (const auto* block = std::get_if<Block>(&obstacle)) {
    for (const glm::dvec2 corner_m : corners_of(*block)) outline.points_m.push_back(corner_m);
    return outline;
  }
  const Rock& rock = std::get<Rock>(obstacle);
  const RockFrame frame = placed(rock, ground);
  for (const glm::dvec3& vertex_m : hull_of(rock).vertices_m)
    outline.points_m.push_back(glm::dvec2(frame.origin_m + frame.axes * vertex_m));
  return outline;
}

std::vector<Footprint> footprints_of(const Wall& wall) {
  std::vector<Footprint> footprints;
  const auto add = [&](const WallPolygon& solid) {
    for (std::vector<glm::dvec2>& piece_m : convex_pieces(solid))
      footprints.push_back(Outline{std::move(piece_m)});
  };
  if (wall.walkers == WallSide::kOutside) {
    add(wall.outline);
    return footprints;
  }
  const FootprintBox box = box_of(Outline{wall.outline.outer_m});
  const glm::dvec2 low_m = box.low_m - kWallReachM, high_m = box.high_m + kWallReachM;
  add({{low_m, {high_m.x, low_m.y}, high_m, {low_m.x, high_m.y}}, {wall.outline.outer_m}});
  for (const std::vector<glm::dvec2>& hole_m : wall.outline.holes_m) add({hole_m, {}});
  return footprints;
}

std::vector<Footprint> footprints_of(const StandingThings& things, const HeightField& ground) {
  std::vector<Footprint> footprints;
  for (const Obstacle& obstacle : things.obstacles) footprints.push_back(footprint_of(obstacle, ground));
  for (const Wall& wall : things.walls) {
    std::vector<Footprint> pieces = footprints_of(wall);
    footprints.insert(footprints.end(), std::make_move_iterator(pieces.begin()),
                      std::make_move_iterator(pieces.end()));
  }
  return footprints;
}

}  // namespace prairie
