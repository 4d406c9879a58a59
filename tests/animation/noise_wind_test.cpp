// The noise that wind is made of: cyclic, of unit variance, carried along by the mean wind.
#include "animation/noise_wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "files/error.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

TEST(NoiseWindTest, KernelRepeatsAfterItsCells) {
  for (float y = -3.0f; y < 3.0f; y += 0.37f) {
    for (float x = -3.0f; x < 3.0f; x += 0.41f) {
      const glm::vec2 here = Kernels{}.wind_noise({x, y}, 16, 7);
      const glm::vec2 there = Kernels{}.wind_noise({x + 16.0f, y - 32.0f}, 16, 7);
      ASSERT_NEAR(here.x, there.x, 1e-5f);
      ASSERT_NEAR(here.y, there.y, 1e-5f);
    }
  }
}

TEST(NoiseWindTest, TexturesHaveMeanZeroAndVarianceOne) {
  const NoiseTexture texture = make_noise_texture(3);
  glm::dvec2 sum(0.0), squares(0.0);
  for (const glm::vec2& texel : texture.texels) {
    sum += glm::dvec2(texel);
    squares += glm::dvec2(texel) * glm::dvec2(texel);
  }
  const double count = 256.0 * 256.0;
  EXPECT_NEAR(sum.x / count, 0.0, 1e-6);
  EXPECT_NEAR(sum.y / count, 0.0, 1e-6);
  EXPECT_NEAR(squares.x / count, 1.0, 1e-5);
  EXPECT_NEAR(squares.y / count, 1.0, 1e-5);
}

TEST(NoiseWindTest, TexturesAreCyclicAndContinuous) {
  const NoiseTexture texture = make_noise_texture(3);
  for (double at = -40.0; at < 40.0; at += 0.173) {
    const glm::vec2 here = texture.sample({at, 0.3 * at}),
                    there = texture.sample({at + 32.0, 0.3 * at - 16.0});
    ASSERT_NEAR(here.x, there.x, 1e-5f) << at;
    const glm::vec2 next = texture.sample({at + 1e-4, 0.3 * at});
    ASSERT_NEAR(here.x, next.x, 5e-3f) << at;
  }
}

TEST(NoiseWindTest, SeedsDiffer) {
  EXPECT_NE(make_noise_texture(3).texels[1000], make_noise_texture(4).texels[1000]);
  EXPECT_EQ(make_noise_texture(3).texels[1000], make_noise_texture(3).texels[1000]);
}

TEST(NoiseWindTest, MovesWithTheWind) {
  const NoiseWind noise(NoiseWindSettings{});
  const glm::dvec2 mean(4.0, 3.0);
  const glm::vec2 here = noise.velocity_m_per_s({10.0, 20.0}, mean, {0.0, 0.0});
  const glm::vec2 downwind = noise.velocity_m_per_s({10.0 + 40.0, 20.0 + 30.0}, mean, {40.0, 30.0});
  EXPECT_NEAR(here.x, downwind.x, 1e-4f);
  EXPECT_NEAR(here.y, downwind.y, 1e-4f);
  EXPECT_EQ(noise.velocity_m_per_s({10.0, 20.0}, {0.0, 0.0}, {5.0, 5.0}), glm::vec2(0.0f)) << "calm";
}

TEST(NoiseWindTest, StaysFineFarAwayAndLate) {
  const NoiseWind noise(NoiseWindSettings{});
  // A day's wind and a thousand kilometres: neighbours still differ by little, and are not the same.
  const glm::dvec2 mean(7.0, 0.0), drift(600000.0, 0.0), far(1e6, 1e6);
  const glm::vec2 a = noise.velocity_m_per_s(far, mean, drift);
  const glm::vec2 b = noise.velocity_m_per_s(far + glm::dvec2(0.05, 0.0), mean, drift);
  EXPECT_NE(a, b);
  EXPECT_NEAR(a.x, b.x, 0.05f);
}

TEST(NoiseWindTest, RefusesBadSettings) {
  const auto refused = [](auto change) {
    NoiseWindSettings settings;
    change(settings);
    EXPECT_THROW(NoiseWind{settings}, BadInput);
  };
  refused([](NoiseWindSettings& settings) { settings.layers[1].size_m = 0.0; });
  refused([](NoiseWindSettings& settings) {
    settings.layers[2].size_m = std::numeric_limits<double>::quiet_NaN();
  });
  refused([](NoiseWindSettings& settings) { settings.layers[0].strength = -0.1f; });
  refused([](NoiseWindSettings& settings) { settings.lateral = std::numeric_limits<float>::infinity(); });
}

}  // namespace
}  // namespace prairie
