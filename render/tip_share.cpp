#include "render/tip_share.h"

#include <cmath>
#include <numbers>

#include "render/sward_sample.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

using Vectors = Kernels::ChainVectors;

constexpr int kDirections = 4;
// A load over κ on each segment that moves the tip of an upright blade by about a quarter of its length.
constexpr float kLoad = 0.05f;

Vectors load_towards(glm::vec3 direction) {
  return {direction * (7.0f * kLoad), direction * (5.0f * kLoad), direction * (3.0f * kLoad), direction * kLoad};
}

float virtual_tip(const SpeciesParams& species, glm::vec3 direction) {
  Kernels kernels;
  const glm::vec3 up(0.0f, 0.0f, 1.0f);
  const Vectors rest{up, up, up, up};
  const float compliance = 1.0f / std::max(species.stiffness, kernels.softest_chain());
  const Vectors along = kernels.chain_directions(rest, kernels.virtual_turns(rest, load_towards(direction), compliance));
  return 0.25f * glm::dot(along.v1 + along.v2 + along.v3 + along.v4, direction);
}

}  // namespace

float tip_share(const SpeciesParams& species) {
  Kernels kernels;
  double moved_m = 0.0, virtual_m = 0.0;
  for (const Blade& blade : sown_blades(species)) {
    const Kernels::BladeCurve rest = kernels.pose_blade(blade, glm::vec2(0.0f), 1.0f);
    const glm::vec3 still_m = kernels.chain_of(blade, rest, 1.0f).p4;
    for (int n = 0; n < kDirections; ++n) {
      const double azimuth = 2.0 * std::numbers::pi * n / kDirections;
      const glm::vec3 direction(glm::dvec3(std::cos(azimuth), std::sin(azimuth), 0.0));
      const glm::vec3 moved = kernels.virtual_pose(blade, rest, 1.0f, load_towards(direction)).p4 - still_m;
      moved_m += static_cast<double>(glm::dot(moved, direction));
      virtual_m += static_cast<double>(blade.height_m * virtual_tip(species, direction));
    }
  }
  return virtual_m > 0.0 ? static_cast<float>(moved_m / virtual_m) : 1.0f;
}

}  // namespace prairie
