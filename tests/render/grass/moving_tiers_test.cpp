// One field moves all tiers (docs/design.md, D4): under one gust blades, strips and the ground's look follow
// it alike.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "animation/sway.h"
#include "lod/sward/sward_sample.h"
#include "lod/sward/tip_share.h"
#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "world/motion.h"
#include "world/scene_wind.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr const char* kScene = R"(version = 1
[ground]
size_m = [200, 200]
[[species]]
name = "fescue"
density = 1400
[[species]]
name = "oatgrass"
density = 150
height_m = 0.72
width_mm = 3.0
tilt_deg = 9
lean_deg = 14
curvature_deg = 34
mass_g = 0.12
stiffness = 40
clump_m = 0.45
tip_color = "#b59a55"
[sun]
azimuth_deg = 285
elevation_deg = 34
[wind]
speed_m_per_s = 1.5
heading_deg = 90
turbulence = 0.3
[[wind.gust]]
position_m = [60, 100]
heading_deg = 90
strength_m_per_s = 6
start_s = 0.5
)";

constexpr double kStepS = 1.0 / 60.0;
constexpr glm::dvec2 kPlaceM{100.0, 100.0};

TEST(MovingTiers, StripsMoveAsFarAsBlades) {
  const Scene scene = parse_scene(kScene, ".", {});
  Wind wind = wind_of(scene);
  std::vector<SwaySpecies> sway_species;
  for (const SpeciesSpec& spec : scene.species) sway_species.push_back({chain_traits_of(spec), 0.5f});
  Sway sway(sway_species, kPlaceM);
  Kernels kernels;
  std::vector<std::vector<Blade>> blades;
  std::vector<TipShare> tip_shares;
  for (const SpeciesSpec& spec : scene.species) {
    blades.push_back(sown_blades(spec.species.params));
    tip_shares.push_back(tip_share(spec.species.params));
  }
  double worst = 0.0, farthest = 0.0;
  int compared = 0;
  for (int step = 1; step <= 720; ++step) {
    sway.step(wind, step * kStepS, static_cast<float>(kStepS));
    if (step % 24 != 0) continue;
    for (std::size_t s = 0; s < blades.size(); ++s) {
      for (const glm::dvec2 offset_m : {glm::dvec2(0.0), glm::dvec2(7.0, -4.0), glm::dvec2(-40.0, 22.0)}) {
        const VirtualTexel texel = sway.at(s, kPlaceM + offset_m);
        const auto& t = texel.segments;
        const Kernels::ChainVectors load = kernels.texel_load(t[0], t[1], t[2], t[3]);
        glm::dvec2 spline(0.0), hermite(0.0);
        double length_m = 0.0;
        for (const Blade& blade : blades[s]) {
          const Kernels::BladeCurve rest = kernels.pose_blade(blade, glm::vec2(0.0f), 1.0f);
          const Kernels::BladeChain moved = kernels.virtual_pose(blade, rest, 1.0f, load);
          const glm::vec3 still_m = kernels.chain_of(blade, rest, 1.0f).p4;
          spline += glm::dvec2(moved.p4 - still_m);
          hermite += glm::dvec2(kernels.curve_of(moved).tip_m - still_m);
          length_m += static_cast<double>(blade.height_m);
        }
        spline /= length_m;
        hermite /= length_m;
        // As shaders/pass/strips.comp moves the top of a strip.
        const glm::dvec2 tip(glm::vec2(kernels.texel_tip(t[0], t[1], t[2])));
        const double share = static_cast<double>(tip_shares[s].still) +
                             static_cast<double>(tip_shares[s].bent) * glm::length(tip);
        const glm::dvec2 strip = share * tip;
        farthest = std::max(farthest, glm::length(spline));
        EXPECT_LT(glm::distance(hermite, spline), 1e-6);
        if (glm::length(spline) < 0.03) continue;
        ++compared;
        worst = std::max(worst, glm::distance(strip, spline) / glm::length(spline));
      }
    }
  }
  std::printf(
      "tips move by up to %.2f of their length; strips are off by at most %.1f %% of that of blades (%d "
      "cases)\n",
      farthest, 100.0 * worst, compared);
  EXPECT_GT(compared, 60);
  EXPECT_GT(farthest, 0.25);
  EXPECT_LE(worst, 0.10);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0, mean_b = 0.0, ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean_a += a[k] / n;
    mean_b += b[k] / n;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

double brightness(const Picture& picture) {
  double sum = 0.0;
  for (const float value : picture.linear_rgb) sum += static_cast<double>(value);
  return sum / static_cast<double>(picture.linear_rgb.size());
}

class MovingTiersTest : public HeadlessTest {};

TEST_F(MovingTiersTest, TheGroundsBrightnessFollowsTheGust) {
  World world(parse_scene(kScene, ".", {}), {});
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  // A few metres of the field, seen as at the far end of a meadow, across the wind.
  Camera camera;
  camera.eye_m = glm::dvec3(kPlaceM - 14.0 * glm::dvec2(camera.forward()), 5.0);
  camera.pitch_rad = -std::atan2(5.0, 14.0);
  camera.fov_rad = 0.14;
  camera.size_px = {48, 48};
  world.watch_anew(kPlaceM);
  std::vector<double> displaced, flat, spline;
  for (int frame = 0; frame < 26; ++frame) {
    for (int step = 0; step < 20; ++step) world.step(kStepS);
    displaced.push_back(static_cast<double>(world.motion().sway()->mean_tip(kPlaceM).x));
    flat.push_back(brightness(renderer.render(camera, {.tier = Tier::kFlat}, 1)));
    spline.push_back(brightness(renderer.render(camera, {.tier = Tier::kSpline}, 4)));
  }
  const double flat_follows = correlation(displaced, flat), spline_follows = correlation(displaced, spline);
  std::printf(
      "correlation of brightness with the tips' displacement: flat %.3f, spline %.3f; of each other: %.3f\n",
      flat_follows, spline_follows, correlation(flat, spline));
  EXPECT_GE(flat_follows, 0.8);
  EXPECT_GE(spline_follows, 0.8);
}

}  // namespace
}  // namespace prairie
