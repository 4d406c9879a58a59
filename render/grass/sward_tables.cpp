#include "render/grass/sward_tables.h"

#include <algorithm>
#include <cmath>

#include "lod/sward/flat_map.h"
#include "lod/sward/sward_response.h"

namespace prairie {
namespace {

constexpr int kPlaces = 64;  // along a side, where the field's mean is taken
// Blades bend, so that a sward stands a little lower than they are long.
constexpr double kStandingShare = 0.8;

double mean_density_per_m2(const Meadow& meadow, const NodeGrid& map) {
  if (map.is_uniform()) return static_cast<double>(map.sample({0.0, 0.0}));
  double sum = 0.0;
  for (int n = 0; n < kPlaces * kPlaces; ++n) {
    const glm::dvec2 place_m =
        (glm::dvec2(n % kPlaces, n / kPlaces) + 0.5) / static_cast<double>(kPlaces) * meadow.extent_m;
    const float value = map.sample(place_m);
    if (value > 0.0f) sum += static_cast<double>(value);  // false for NaN
  }
  return sum / (kPlaces * kPlaces);
}

GlTexture upload(const SwardResponse& response, std::vector<glm::vec4> SwardResponse::Colors::*table) {
  GlTexture texture = make_texture(GL_TEXTURE_3D);
  const int slices = SwardResponse::kDepths * static_cast<int>(1 + response.layers.size());
  glTextureStorage3D(texture.get(), 1, GL_RGBA16F, SwardResponse::kElevations, SwardResponse::kAzimuths,
                     slices);
  const auto put = [&](int slice, const SwardResponse::Colors& colors) {
    glTextureSubImage3D(texture.get(), 0, 0, 0, slice, SwardResponse::kElevations, SwardResponse::kAzimuths,
                        SwardResponse::kDepths, GL_RGBA, GL_FLOAT, (colors.*table).data());
  };
  put(0, response.colors);
  for (std::size_t n = 0; n < response.layers.size(); ++n)
    put(SwardResponse::kDepths * static_cast<int>(n + 1), response.layers[n].colors);
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(texture.get(), axis, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

SwardTables::SwardTables(const Meadow& meadow) {
  double sum = 0.0;
  for (const PlantedSpecies& species : meadow.species) {
    species_.push_back(species.species.params);
    species_.back().densest_per_m2 = static_cast<float>(std::max(densest_per_m2(species), 1e-3));
    densities_per_m2_.push_back(mean_density_per_m2(meadow, species.density_per_m2));
    sum += densities_per_m2_.back();
  }
  // A bare field still has a look, should somebody sow it.
  if (sum <= 0.0) std::fill(densities_per_m2_.begin(), densities_per_m2_.end(), 1.0);
}

void SwardTables::set_light(const FrameParams& light) {
  std::vector<SwardLayer> layers;
  for (std::size_t s = 0; s < species_.size(); ++s) layers.push_back({&species_[s], densities_per_m2_[s]});
  const SwardResponse response = sward_response(layers, light);
  free_ = upload(response, &SwardResponse::Colors::free);
  shaded_ = upload(response, &SwardResponse::Colors::shaded);

  blade_area_from_above_m2_.clear();
  double blades = 0.0, leaf_area = 0.0, seen_area = 0.0, height_m = 0.0, width_m = 0.0;
  glm::dvec3 albedo(0.0);
  for (std::size_t s = 0; s < species_.size(); ++s) {
    const SwardResponse::Layer& layer = response.layers[s];
    species_[s].blade_area_m2 = static_cast<float>(layer.blade_area_m2);
    const double seen_m2 = layer.blade_area_m2 * static_cast<double>(layer.projected.back());
    blade_area_from_above_m2_.push_back(seen_m2);
    const double density = densities_per_m2_[s];
    blades += density;
    leaf_area += density * layer.blade_area_m2;
    seen_area += density * seen_m2;
    height_m += density * layer.blade_area_m2 * kStandingShare * static_cast<double>(species_[s].height_m);
    width_m += density * layer.blade_area_m2 * static_cast<double>(species_[s].width_m);
    albedo += density * seen_m2 * glm::dvec3(mean_albedo(species_[s]));
  }
  field_.mean_albedo = glm::vec3(albedo / seen_area);
  field_.projected_from_above = seen_area / leaf_area;
  field_.density_per_leaf_area = blades / leaf_area;
  field_.height_m = height_m / leaf_area;
  field_.blade_width_m = width_m / leaf_area;
}

void SwardTables::bind() const {
  glBindTextureUnit(5, free_.get());
  glBindTextureUnit(6, shaded_.get());
}

}  // namespace prairie
