#include "bench/scale_shares.h"

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace prairie {
namespace {

// As in shaders/lib/tint.glsl, in the order of its tiers; only the hues matter.
const std::array<glm::vec3, 4> kTints{
    {{1.0f, 0.25f, 0.2f}, {1.0f, 0.85f, 0.2f}, {0.25f, 1.0f, 0.3f}, {0.3f, 0.5f, 1.0f}}};
// The share of a pixel's own colour that tinting keeps.
constexpr float kKept = 0.25f;

glm::vec3 color_at(const Picture& picture, std::size_t pixel) {
  return {picture.linear_rgb[3 * pixel], picture.linear_rgb[3 * pixel + 1],
          picture.linear_rgb[3 * pixel + 2]};
}

std::size_t nearest_tint(const glm::vec3& hue) {
  std::size_t nearest = 0;
  for (std::size_t n = 1; n < kTints.size(); ++n) {
    if (glm::dot(hue, glm::normalize(kTints[n])) > glm::dot(hue, glm::normalize(kTints[nearest])))
      nearest = n;
  }
  return nearest;
}

}  // namespace

TierShares tier_shares(Renderer& renderer, const Camera& camera) {
  const Picture plain = renderer.render(camera, {}, 1);
  const Picture tinted = renderer.render(camera, {.tier_tint = true}, 1);
  const Picture flat = renderer.render(camera, {.tier = Tier::kFlat}, 1);  // tells bare floor from sky
  std::array<double, 4> covered{};
  TierShares shares;
  double ground = 0.0;
  for (std::size_t pixel = 0; pixel < plain.cover.size(); ++pixel) {
    const float cover = plain.cover[pixel];
    if (cover == 0.0f && flat.cover[pixel] == 0.0f) continue;
    ground += 1.0;
    if (cover == 1.0f) {
      // What tinting added has the tint's hue.
      covered[nearest_tint(color_at(tinted, pixel) - kKept * color_at(plain, pixel))] += 1.0;
    } else {
      // The ground, which shows the flat tier as far as the floor is covered.
      shares.flat += static_cast<double>(cover);
      shares.floor += 1.0 - static_cast<double>(cover);
    }
  }
  shares.spline = covered[0] / ground;
  shares.hermite = covered[1] / ground;
  shares.strip = covered[2] / ground;
  shares.flat = (shares.flat + covered[3]) / ground;
  shares.floor /= ground;
  return shares;
}

}  // namespace prairie
