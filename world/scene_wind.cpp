#include "world/scene_wind.h"

#include <utility>

#include "animation/heading.h"
#include "animation/inertial_chains.h"
#include "maps/wind_file.h"
#include "world/scene/bearing.h"

namespace prairie {
namespace {

MeanWind mean_wind_of(const WindSpec& spec, glm::dvec2 middle_m) {
  if (!spec.file) return MeanWind(spec.speed_m_per_s * direction_of(heading_rad_of(spec.heading_deg)));
  WindFile measured = read_wind_file(*spec.file);
  WindSeries series;
  series.times_s = std::move(measured.times_s);
  series.speeds_m_per_s = std::move(measured.speeds_m_per_s);
  series.headings_rad = std::move(measured.headings_rad);
  series.place_m = spec.place_m.value_or(middle_m);
  return MeanWind(series);
}

}  // namespace

std::optional<NoiseWind> turbulence_of(const Scene& scene, double factor) {
  if (factor == 0.0) return std::nullopt;
  NoiseWindSettings settings;
  settings.seed = static_cast<std::uint32_t>(scene.seed ^ (scene.seed >> 32));
  for (WindLayer& layer : settings.layers) layer.strength *= static_cast<float>(factor);
  return NoiseWind(settings);
}

Wind wind_of(const Scene& scene, glm::dvec2 middle_m) {
  Wind wind;
  if (!scene.wind) return wind;
  wind.mean = mean_wind_of(*scene.wind, middle_m);
  // Turbulence goes by the mean wind: calm air has none.
  const bool blows = scene.wind->file || scene.wind->speed_m_per_s > 0.0;
  if (blows) wind.noise = turbulence_of(scene, scene.wind->turbulence);
  wind.primitives = scene.wind->primitives;
  return wind;
}

ChainTraits chain_traits_of(const SpeciesSpec& spec) {
  const SpeciesParams& params = spec.species.params;
  ChainTraits traits;
  traits.half_segment_m = params.height_m / 8.0f;
  traits.stiffness = params.stiffness;
  traits.damping_ratio = static_cast<float>(spec.motion.damping_ratio);
  traits.drag = chain_drag(params.width_m, params.height_m, params.mass_g,
                           static_cast<float>(spec.motion.drag_coefficient));
  return traits;
}

}  // namespace prairie
