// Treads as a texture, and the rest shape that they give to blades.
#include "animation/tread_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "animation/sway.h"
#include "chain_cases.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kTreadSide;

TreadTexel texel(const TreadWindow& window, int level, glm::dvec2 position_m) {
  const double size_m = 64.0 / kSide * std::pow(4.0, level);
  const auto wrapped = [](double x) {
    return static_cast<std::size_t>(((static_cast<int>(std::floor(x)) % kSide) + kSide) % kSide);
  };
  return window.image()[static_cast<std::size_t>(level) * kSide * kSide +
                        wrapped(position_m.y / size_m) * kSide + wrapped(position_m.x / size_m)];
}

TEST(TreadWindow, HoldsWhatWasTrodden) {
  Treading treading{TreadSettings{}};
  TreadWindow window;
  window.paint(treading, {0.0, 0.0});
  EXPECT_TRUE(window.is_empty());
  const TreadStep step{1, {-3.0, 2.03}, {4.0, 2.03}, 0.2, 1.0};
  treading.step({&step, 1}, 1.0);
  window.paint(treading, {0.0, 0.0});
  EXPECT_FALSE(window.is_empty());
  for (const glm::dvec2 place :
       {glm::dvec2(0.0625, 2.0625), glm::dvec2(2.3125, 2.1875), glm::dvec2(-2.9375, 2.0625)}) {
    const Tread tread = treading.sample(place);
    const TreadTexel found = texel(window, 0, place);
    EXPECT_NEAR(found[2] / 127.0, static_cast<double>(tread.tilt_rad / layouts::kTreadMostRad), 1.0 / 127.0);
    EXPECT_NEAR(found[0] / 127.0, static_cast<double>(tread.lean_rad.x / layouts::kTreadMostRad),
                1.0 / 127.0);
  }
  EXPECT_EQ(texel(window, 0, {0.0, 8.0}), TreadTexel{});
  EXPECT_EQ(texel(window, 1, {0.2, 2.2}), TreadTexel{})
      << "where the finer window is read the coarser one need not hold it";
  window.paint(treading, {34.0, 0.0});
  EXPECT_GT(texel(window, 1, {0.2, 2.2})[2], 10) << "beyond the finer window the coarser one has it";

  // Once the eye is far away nothing of it is left, nor wraps around.
  window.paint(treading, {1000.0, 0.0});
  EXPECT_TRUE(window.is_empty());
  window.paint(treading, {64.0, 0.0});
  EXPECT_EQ(texel(window, 0, {0.0625, 2.0625}), TreadTexel{});
  EXPECT_GT(texel(window, 1, {0.2, 2.2})[2], 10);
}

TreadStep random_step(std::mt19937& random, std::uint32_t id) {
  const glm::dvec2 from_m(uniform(random, -40.0, 40.0), uniform(random, -40.0, 40.0));
  return {id, from_m, from_m + glm::dvec2(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0)),
          uniform(random, 0.1, 1.0), 1.0};
}

TEST(TreadWindow, TexelsAreMeansOfWhatLiesInThem) {
  for (const double spacing_m : {0.125, 0.2, 0.25, 0.1}) {
    TreadSettings settings;
    settings.spacing_m = spacing_m;
    Treading treading(settings);
    std::mt19937 random(8);
    for (int n = 0; n < 60; ++n) {
      const TreadStep step = random_step(random, 1);
      treading.step({&step, 1}, 0.1 * (n + 1));
    }
    TreadWindow window;
    const glm::dvec2 eye_m(3.3, -1.7);
    window.paint(treading, eye_m);
    int trodden = 0;
    for (int level = 0; level < 2; ++level) {
      const double size_m = 64.0 / kSide * std::pow(4.0, level),
                   aside_m = size_m <= spacing_m ? 0.0 : 0.25 * size_m;
      for (int n = 0; n < 20000; ++n) {
        const double from_m = level == 0 ? 0.0 : 31.0, to_m = level == 0 ? 30.0 : 50.0;
        const double away_m = uniform(random, from_m, to_m), aside = uniform(random, -away_m, away_m);
        const double sign = n % 2 == 0 ? 1.0 : -1.0;
        const glm::dvec2 away =
            n % 4 < 2 ? glm::dvec2(sign * away_m, aside) : glm::dvec2(aside, sign * away_m);
        const glm::dvec2 middle_m = (glm::floor((eye_m + away) / size_m) + 0.5) * size_m;
        glm::vec4 mean(0.0f);
        for (const double x : {-aside_m, aside_m}) {
          for (const double y : {-aside_m, aside_m}) {
            const Tread tread = treading.sample(middle_m + glm::dvec2(x, y));
            mean += 0.25f * glm::vec4(tread.lean_rad, tread.tilt_rad, tread.wear * layouts::kTreadMostRad);
          }
        }
        const TreadTexel found = texel(window, level, middle_m);
        for (int c = 0; c < 4; ++c)
          ASSERT_NEAR(static_cast<float>(found[static_cast<std::size_t>(c)]),
                      127.0f * mean[c] / layouts::kTreadMostRad, 0.51f)
              << spacing_m << ' ' << level << ' ' << middle_m.x << ' ' << middle_m.y;
        trodden += found[2] > 20;
      }
    }
    EXPECT_GT(trodden, 1000);
  }
}

TEST(TreadWindow, TellsWhichRowsHaveChanged) {
  Treading treading{TreadSettings{}};
  TreadWindow window;
  std::mt19937 random(9);
  std::vector<TreadTexel> shown(window.image().begin(), window.image().end());
  for (int n = 0; n < 40; ++n) {
    const TreadStep step = random_step(random, 1);
    treading.step({&step, 1}, 5.0 * (n + 1));
    const glm::dvec2 eye_m(0.37 * n, n < 30 ? -0.2 * n : 500.0);
    // As if some were painted and never shown.
    if (n % 3 == 0) window.paint(treading, eye_m + 2.0);
    window.paint(treading, eye_m);
    for (const TreadWindow::Rows& rows : window.take_changed()) {
      const auto first = (static_cast<std::ptrdiff_t>(rows.layer) * kSide + rows.first) * kSide;
      std::copy_n(window.image().begin() + first, static_cast<std::ptrdiff_t>(rows.count) * kSide,
                  shown.begin() + first);
    }
    TreadWindow fresh;
    fresh.paint(treading, eye_m);
    ASSERT_TRUE(std::ranges::equal(shown, fresh.image())) << n;
    window.paint(treading, eye_m);
    EXPECT_TRUE(window.take_changed().empty()) << "painted already";
  }
}

TEST(PressedCurve, LiesAsFarAsItIsTrodden) {
  std::mt19937 random(5);
  Kernels kernels;
  for (int n = 0; n < 3000; ++n) {
    Blade blade{};
    blade.height_m = static_cast<float>(uniform(random, 0.1, 0.8));
    blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 6.28));
    blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 0.4));
    blade.curvature_rad = static_cast<float>(uniform(random, 0.0, 1.5));
    blade.stiffness = static_cast<float>(uniform(random, 40.0, 200.0));
    const glm::vec2 slope(static_cast<float>(uniform(random, -0.4, 0.4)),
                          static_cast<float>(uniform(random, -0.4, 0.4)));
    const glm::vec3 normal = kernels.normalized(glm::vec3(-slope.x, -slope.y, 1.0f));
    const auto tilt = static_cast<float>(uniform(random, 0.0, 1.45));
    const auto heading = static_cast<float>(uniform(random, 0.0, 6.28));
    const Kernels::Pressing pressing{tilt * glm::vec2(std::cos(heading), std::sin(heading)), tilt, 0.0f};
    const Kernels::BladeCurve rest = kernels.pose_blade(blade, slope, 1.0f);
    const Kernels::BladeCurve pressed = kernels.pressed_curve(rest, blade.height_m, normal, pressing);

    // The length stays, the side lies across, the tip comes down as the tilt says and goes where the tread
    // went.
    double length_m = 0.0;
    glm::vec3 last = pressed.base_m;
    for (int k = 1; k <= 64; ++k) {
      const glm::vec3 point = kernels.hermite_point(pressed.base_m, pressed.tip_m, pressed.base_tangent_m,
                                                    pressed.tip_tangent_m, static_cast<float>(k) / 64.0f);
      length_m += static_cast<double>(glm::distance(point, last));
      last = point;
      ASSERT_GE(glm::dot(point - pressed.base_m, normal),
                std::min(glm::dot(rest.tip_m - rest.base_m, normal), 0.0f) - 1e-4f);
    }
    ASSERT_NEAR(length_m / static_cast<double>(blade.height_m), 1.0, 0.01);
    ASSERT_NEAR(glm::dot(pressed.side, kernels.normalized(pressed.base_tangent_m)), 0.0f, 1e-3f);
    const glm::vec3 chord = kernels.normalized(pressed.tip_m - pressed.base_m);
    if (tilt > 1.3f) {
      ASSERT_LT(glm::dot(chord, normal), 0.3f);
      ASSERT_GT(glm::dot(glm::vec2(chord), glm::vec2(std::cos(heading), std::sin(heading))), 0.5f);
    }
    if (tilt < 0.01f) {
      ASSERT_LT(glm::distance(chord, kernels.normalized(rest.tip_m - rest.base_m)), 0.03f);
    }
  }
}

TEST(PressedCurve, DoesNotSagIntoTheGround) {
  std::mt19937 random(6);
  Kernels kernels;
  for (int n = 0; n < 2000; ++n) {
    Blade blade{};
    blade.height_m = static_cast<float>(uniform(random, 0.1, 0.8));
    blade.azimuth_rad = static_cast<float>(uniform(random, 0.0, 6.28));
    blade.tilt_rad = static_cast<float>(uniform(random, 0.0, 0.3));
    blade.curvature_rad = static_cast<float>(uniform(random, 0.0, 1.2));
    blade.stiffness = static_cast<float>(uniform(random, 40.0, 200.0));
    const Kernels::Pressing pressing{{1.4f, 0.0f}, 1.4f, 0.0f};
    const glm::vec3 up(0.0f, 0.0f, 1.0f);
    const Kernels::BladeCurve rest = kernels.pose_blade(blade, glm::vec2(0.0f), 1.0f);
    const Kernels::BladeChain chain =
        kernels.pressed_virtual_pose(blade, rest, 1.0f, ChainVectors{}, up, pressing);
    for (int k = 0; k <= 32; ++k)
      ASSERT_GT(kernels.chain_point(chain, static_cast<float>(k) / 32.0f).z, -0.01f * blade.height_m);
    ASSERT_LT(chain.p4.z, 0.2f * blade.height_m);
  }
}

}  // namespace
}  // namespace prairie
