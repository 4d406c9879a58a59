#include "render/things/drawn_walkers.h"

#include <glm/geometric.hpp>

#include "agents/walker_pose.h"
#include "lod/frustum.h"

namespace prairie {
namespace {

constexpr double kReach = 0.8;  // of arms and strides, as a share of the height

}  // namespace

std::vector<WalkerLook> drawn_walkers(const World& world, const Camera& camera) {
  std::vector<WalkerLook> looks;
  const std::span<const Walker> walkers = world.walkers();
  const std::span<const WalkerTraits> traits = world.walker_traits();
  const HeightField& ground = world.meadow().ground;
  const Frustum frustum(camera);
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    if (!world.is_present(n)) continue;
    const Walker& walker = walkers[n];
    const double height_m = traits[n].height_m;
    const glm::dvec3 place_m(walker.position_m, static_cast<double>(ground.height_m(walker.position_m)));
    const double reach_m = kReach * height_m;
    if (!frustum.may_see({place_m - reach_m, place_m + glm::dvec3(reach_m, reach_m, 1.3 * height_m)}))
      continue;
    if (height_m < camera.pixel_m_at(glm::distance(place_m, camera.eye_m))) continue;
    looks.push_back({height_m, traits[n].id,
                     pose_of(world.gait(), walker.footing, walker.position_m, walker.forward, ground)});
  }
  return looks;
}

}  // namespace prairie
