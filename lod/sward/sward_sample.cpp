#include "lod/sward/sward_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/plant.h"

namespace prairie {
namespace {

constexpr int kPlanted = 4096;  // of which the samples are taken
constexpr int kSamples = 1024;
constexpr int kPartsOfABlade = 5;
constexpr double kTuftsAcross = 40.0;  // of the square that is planted
// The share of blades at the top of which as many samples are taken as of an eᵗʰ of the rest.
constexpr double kTallShare = 0.03;

}  // namespace

std::vector<Blade> sown_blades(const SpeciesParams& params) {
  Meadow meadow;
  meadow.tile_m = std::clamp(kTuftsAcross * static_cast<double>(params.clump_m), 4.0, 64.0);
  meadow.extent_m = glm::dvec2(meadow.tile_m);
  PlantedSpecies planted;
  planted.species.params = params;
  planted.density_per_m2 = NodeGrid::uniform(static_cast<float>(kPlanted / (meadow.tile_m * meadow.tile_m)));
  meadow.species.push_back(std::move(planted));
  return plant_tile(meadow, {0, 0});
}

namespace {

struct SampleBlade {
  Blade blade;
  Kernels::BladeCurve curve;
  float top_m;
};

glm::vec3 point_at(const Kernels::BladeCurve& curve, float t) {
  return Kernels{}.hermite_point(curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m, t);
}

// Blades at rest, from the tallest to the lowest.
std::vector<SampleBlade> posed_blades(const SpeciesParams& species) {
  std::vector<SampleBlade> posed;
  for (Blade blade : sown_blades(species)) {
    blade.root_m = glm::vec2(0.0f);
    blade.ground_m = 0.0f;
    SampleBlade sample{blade, resting_curve(blade), 0.0f};
    for (const float t : {0.4f, 0.6f, 0.8f, 1.0f})
      sample.top_m = std::max(sample.top_m, point_at(sample.curve, t).z);
    posed.push_back(sample);
  }
  std::stable_sort(posed.begin(), posed.end(),
                   [](const SampleBlade& a, const SampleBlade& b) { return a.top_m > b.top_m; });
  return posed;
}

double fraction(double x) {
  return x - std::floor(x);
}

// Turned about the vertical.
glm::vec3 turned(glm::vec3 v, float cosine, float sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

// A piece of a sample blade.
struct Element {
  float height_m, area_m2, reach_m, place;
  glm::vec3 along, side, root_albedo, tip_albedo;
};

// `weight`: how many of kSamples blades it stands for. Where sample k is cut and where it points to follow
// two irrational steps, so that both are spread well over every run of blades of about one height.
void cut(const SpeciesParams& species, const SampleBlade& sample, int k, double weight,
         std::vector<Element>& out) {
  Kernels kernels;
  const Kernels::BladeCurve& curve = sample.curve;
  const double offset = fraction(0.7548776662466927 * k);
  const double heading = 2.0 * std::numbers::pi * fraction(0.6180339887498949 * k);
  const glm::vec3 lean = curve.tip_m - curve.base_m;
  const double turn = heading - std::atan2(static_cast<double>(lean.y), static_cast<double>(lean.x));
  const auto turn_cosine = static_cast<float>(std::cos(turn));
  const auto turn_sine = static_cast<float>(std::sin(turn));
  const glm::vec3 root = kernels.root_albedo(species, sample.blade.hue, sample.blade.dryness);
  const glm::vec3 tip = kernels.tip_albedo(species, sample.blade.hue, sample.blade.dryness);
  const auto share = static_cast<float>(weight / (kSamples * kPartsOfABlade));
  for (int part = 0; part < kPartsOfABlade; ++part) {
    const auto t = static_cast<float>((part + offset) / kPartsOfABlade);
    Element element;
    element.height_m = point_at(curve, t).z;
    if (element.height_m < 0.0f) continue;
    const glm::vec3 along =
        kernels.hermite_derivative(curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m, t);
    element.along = turned(along, turn_cosine, turn_sine);
    element.side = turned(curve.side, turn_cosine, turn_sine);
    element.reach_m = share * sample.blade.width_m * kernels.blade_profile(t);
    element.area_m2 = element.reach_m * std::sqrt(kernels.inner(along, along));
    element.place = t;
    element.root_albedo = root;
    element.tip_albedo = tip;
    out.push_back(element);
  }
}

}  // namespace

Kernels::BladeCurve resting_curve(const Blade& blade) {
  Kernels kernels;
  return kernels.curve_of(kernels.chain_of(blade, kernels.pose_blade(blade, glm::vec2(0.0f), 1.0f), 1.0f));
}

SwardElements sward_elements(const SpeciesParams& species) {
  const std::vector<SampleBlade> blades = posed_blades(species);
  std::vector<Element> cuts;
  cuts.reserve(static_cast<std::size_t>(kSamples) * kPartsOfABlade);
  for (int k = 0; k < kSamples; ++k) {
    // Ranks with a density of 1/(rank + kTallShare), from 0 (tallest) to 1.
    const double growth = std::log(1.0 + 1.0 / kTallShare);
    const double spread = std::exp(growth * (k + 0.5) / kSamples);
    const double rank = kTallShare * (spread - 1.0);
    const double weight = kTallShare * growth * spread;
    const auto index = static_cast<std::size_t>(rank * static_cast<double>(blades.size()));
    cut(species, blades[std::min(index, blades.size() - 1)], k, weight, cuts);
  }
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const Element& a, const Element& b) { return a.height_m > b.height_m; });
  SwardElements elements;
  for (const Element& cut : cuts) {
    elements.height_m.push_back(cut.height_m);
    elements.area_m2.push_back(cut.area_m2);
    elements.reach_m.push_back(cut.reach_m);
    elements.along_x.push_back(cut.along.x);
    elements.along_y.push_back(cut.along.y);
    elements.along_z.push_back(cut.along.z);
    elements.side_x.push_back(cut.side.x);
    elements.side_y.push_back(cut.side.y);
    elements.side_z.push_back(cut.side.z);
    elements.place.push_back(cut.place);
    elements.root_albedo.push_back(cut.root_albedo);
    elements.tip_albedo.push_back(cut.tip_albedo);
  }
  return elements;
}

}  // namespace prairie
