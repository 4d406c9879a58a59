// The turbulence at a fixed place, scaled to a mean wind, against what was measured over low vegetation
// (Finse, 110 half hours above 3 m/s at 4.4 m): intensity 0.215, 3 s gust 1.62 times the mean, integral
// length about 120 m, σv/σu 0.87.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/mean_wind.h"
#include "animation/noise_wind.h"

namespace prairie {
namespace {

constexpr int kSamples = 18000;  // 10 Hz, 30 min
constexpr double kMeanSpeed = 6.9;

struct Statistics {
  double intensity, gust_factor, lateral, length_m;
};

Statistics statistics(std::uint32_t seed) {
  NoiseWindSettings settings;
  settings.seed = seed;
  const NoiseWind noise(settings);
  // A direction of its own for each seed.
  const double angle = 2.399963229728653 * seed;
  const glm::dvec2 along(std::cos(angle), std::sin(angle));
  const MeanWind mean(kMeanSpeed * along);
  std::vector<double> u, v, speed;
  for (int n = 0; n < kSamples; ++n) {
    const double time_s = 0.1 * n;
    const glm::dvec2 place_m(31.0, -17.0);
    const glm::dvec2 w = mean.velocity_m_per_s(place_m, time_s) +
                         glm::dvec2(noise.velocity_m_per_s(place_m, mean.velocity_m_per_s(place_m, time_s),
                                                           mean.drift_m(time_s)));
    u.push_back(w.x * along.x + w.y * along.y);
    v.push_back(w.y * along.x - w.x * along.y);
    speed.push_back(std::hypot(w.x, w.y));
  }
  const auto mean_of = [](const std::vector<double>& x) {
    double sum = 0.0;
    for (const double value : x) sum += value;
    return sum / static_cast<double>(x.size());
  };
  const auto deviation = [&](const std::vector<double>& x) {
    const double mean_x = mean_of(x);
    double sum = 0.0;
    for (const double value : x) sum += (value - mean_x) * (value - mean_x);
    return std::sqrt(sum / static_cast<double>(x.size()));
  };
  Statistics result{};
  const double mean_u = mean_of(u);
  result.intensity = deviation(u) / mean_u;
  result.lateral = deviation(v) / deviation(u);
  double window = 0.0, most = 0.0;
  for (int n = 0; n < kSamples; ++n) {
    window += speed[static_cast<std::size_t>(n)];
    if (n >= 30) window -= speed[static_cast<std::size_t>(n - 30)];
    if (n >= 29) most = std::max(most, window / 30.0);
  }
  result.gust_factor = most / mean_of(speed);
  // Integral of the autocorrelation to its first zero.
  double variance = 0.0;
  for (const double value : u) variance += (value - mean_u) * (value - mean_u);
  double integral_s = 0.0;
  for (int lag = 0; lag < 3000; lag += 5) {
    double sum = 0.0;
    for (int n = 0; n + lag < kSamples; ++n) {
      sum += (u[static_cast<std::size_t>(n)] - mean_u) * (u[static_cast<std::size_t>(n + lag)] - mean_u);
    }
    if (sum <= 0.0) break;
    integral_s += 0.5 * (sum / variance);
  }
  result.length_m = integral_s * kMeanSpeed;
  return result;
}

TEST(WindStatisticsTest, TurbulenceAndGustsAreThoseMeasured) {
  constexpr int kSeeds = 20;
  Statistics mean{};
  double least_intensity = 1.0, most_intensity = 0.0, least_gust = 9.0, most_gust = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const Statistics one = statistics(seed);
    mean.intensity += one.intensity / kSeeds;
    mean.gust_factor += one.gust_factor / kSeeds;
    mean.lateral += one.lateral / kSeeds;
    mean.length_m += one.length_m / kSeeds;
    least_intensity = std::min(least_intensity, one.intensity);
    most_intensity = std::max(most_intensity, one.intensity);
    least_gust = std::min(least_gust, one.gust_factor);
    most_gust = std::max(most_gust, one.gust_factor);
    EXPECT_NEAR(one.intensity, 0.215, 0.2 * 0.215) << "seed " << seed;
    EXPECT_NEAR(one.gust_factor, 1.62, 0.2 * 1.62) << "seed " << seed;
  }
  std::printf(
      "intensity %.3f (%.3f to %.3f), 3 s gust %.2f (%.2f to %.2f), lateral %.2f, integral length %.0f m\n",
      mean.intensity, least_intensity, most_intensity, mean.gust_factor, least_gust, most_gust, mean.lateral,
      mean.length_m);
  EXPECT_NEAR(mean.intensity, 0.215, 0.1 * 0.215);
  EXPECT_NEAR(mean.gust_factor, 1.62, 0.1 * 1.62);
  EXPECT_NEAR(mean.lateral, 0.87, 0.15 * 0.87);
}

}  // namespace
}  // namespace prairie
