#include "lod/sward/tip_share.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lod/sward/sward_sample.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

using Vectors = Kernels::ChainVectors;

constexpr int kDirections = 4;
// Loads over κ on each segment that move the tip of an upright blade by a fifth and by two thirds of its
// length.
constexpr float kLightLoad = 0.04f, kHeavyLoad = 0.2f;

Vectors load_towards(glm::vec3 direction, float load) {
  return {direction * (7.0f * load), direction * (5.0f * load), direction * (3.0f * load), direction * load};
}

float virtual_tip(const SpeciesParams& species, float load) {
  Kernels kernels;
  const glm::vec3 up(0.0f, 0.0f, 1.0f), east(1.0f, 0.0f, 0.0f);
  const Vectors rest{up, up, up, up};
  const float compliance = 1.0f / std::max(species.stiffness, kernels.softest_chain());
  const Vectors along =
      kernels.chain_directions(rest, kernels.virtual_turns(rest, load_towards(east, load), compliance));
  return 0.25f * glm::dot(along.v1 + along.v2 + along.v3 + along.v4, east);
}

struct Point {
  float virtual_tip, tip;
};

Point moved_by(const SpeciesParams& species, const std::vector<Blade>& blades, float load) {
  Kernels kernels;
  double moved_m = 0.0, length_m = 0.0;
  for (const Blade& blade : blades) {
    const Kernels::BladeCurve rest = kernels.pose_blade(blade, glm::vec2(0.0f), 1.0f);
    const glm::vec3 still_m = kernels.chain_of(blade, rest, 1.0f).p4;
    for (int n = 0; n < kDirections; ++n) {
      const double azimuth = 2.0 * std::numbers::pi * n / kDirections;
      const glm::vec3 direction(glm::dvec3(std::cos(azimuth), std::sin(azimuth), 0.0));
      const glm::vec3 moved =
          kernels.virtual_pose(blade, rest, 1.0f, load_towards(direction, load)).p4 - still_m;
      moved_m += static_cast<double>(glm::dot(moved, direction));
      length_m += static_cast<double>(blade.height_m);
    }
  }
  return {virtual_tip(species, load), length_m > 0.0 ? static_cast<float>(moved_m / length_m) : 0.0f};
}

}  // namespace

TipShare tip_share(const SpeciesParams& species) {
  const std::vector<Blade> blades = sown_blades(species);
  const Point light = moved_by(species, blades, kLightLoad), heavy = moved_by(species, blades, kHeavyLoad);
  const float light_share = light.tip / light.virtual_tip, heavy_share = heavy.tip / heavy.virtual_tip;
  const float bent = (heavy_share - light_share) / (heavy.virtual_tip - light.virtual_tip);
  return {light_share - bent * light.virtual_tip, bent};
}

}  // namespace prairie
