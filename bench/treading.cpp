#include "animation/treading.h"

#include <cmath>
#include <vector>

#include "animation/wind.h"
#include "bench/benches.h"
#include "bench/timing.h"

namespace prairie {
namespace {

constexpr int kSteps = 300;
constexpr double kStepS = 1.0 / 60.0;
constexpr std::uint32_t kBodies = 1000;
constexpr double kSquareM = 100.0;

/// Walkers on circles of 2 to 7 m, strewn over the square.
glm::dvec2 place_of(std::uint32_t body, int step) {
  const double radius_m = 2.0 + 0.37 * (body % 13);
  const double angle = 2.399963229728653 * body + 1.2 * kStepS * step / radius_m;
  const glm::dvec2 middle_m(std::fmod(0.7548776662466927 * body, 1.0),
                            std::fmod(0.5698402909980532 * body, 1.0));
  return kSquareM * middle_m + radius_m * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace

std::vector<Measurement> bench_treading(const BenchOptions&) {
  Treading treading(TreadSettings{});
  std::vector<TreadStep> steps(kBodies);
  const double median = median_ms(kSteps, [&](int step) {
    for (std::uint32_t body = 0; body < kBodies; ++body) {
      steps[body] = {.id = body, .from_m = place_of(body, step), .to_m = place_of(body, step + 1)};
    }
    return elapsed_ms([&] { treading.step(steps, (step + 1) * kStepS); });
  });
  return {{"treading.step_ms_1000", median}};
}

std::vector<Measurement> bench_wind_nodes(const BenchOptions&) {
  Wind wind;
  wind.mean = MeanWind(glm::dvec2(5.0, 2.0));
  wind.noise.emplace(NoiseWindSettings{});
  wind.primitives = {Gust{}, Tornado{}, Breeze{.radius_m = 30.0}};
  const WindNodes nodes = wind_nodes_around({0.0, 0.0}, 64, 1.0);
  std::vector<glm::vec2> values(64 * 64);
  const double median = median_ms(
      kSteps, [&](int step) { return elapsed_ms([&] { fill_wind(wind, nodes, kStepS * step, values); }); });
  return {{"wind.nodes_ms_64x64", median}};
}

}  // namespace prairie
