#include "world/scene_wind.h"
#include <cmath>
namespace prairie {
Wind wind_of(const Scene& scene) {
  Wind wind;
  if (!scene.wind) return wind;
  const double a = (90.0 - scene.wind->heading_deg) * 0.017453292519943295;
  wind.mean = MeanWind(scene.wind->speed_m_per_s * glm::dvec2(std::cos(a), std::sin(a)));
  if (scene.wind->turbulence > 0.0) wind.noise.emplace(NoiseWindSettings{});
  wind.primitives = scene.wind->primitives;
  return wind;
}
ChainTraits chain_traits_of(const SpeciesSpec& spec) {
  const SpeciesParams& p = spec.species.params;
  return {p.height_m / 8.0f, p.stiffness, static_cast<float>(spec.motion.damping_ratio),
          chain_drag(p.width_m, p.height_m, p.mass_g, static_cast<float>(spec.motion.drag_coefficient))};
}
}  // namespace prairie
