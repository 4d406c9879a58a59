// Constant and replayed wind.
#include "animation/mean_wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "files/error.h"

namespace prairie {
namespace {

WindSeries wavering_series() {
  WindSeries series;
  for (int n = 0; n < 300; ++n) {
    series.times_s.push_back(100.0 + 0.5 * n + 0.1 * std::sin(n));
    series.speeds_m_per_s.push_back(5.0 + 2.0 * std::sin(0.1 * n));
    series.headings_rad.push_back(3.0 + 0.5 * std::sin(0.07 * n));  // through the cut at π
  }
  series.place_m = {12.0, -5.0};
  return series;
}

TEST(MeanWindTest, ConstantWindDriftsSteadily) {
  const MeanWind wind(glm::dvec2(3.0, -1.0));
  EXPECT_EQ(wind.velocity_m_per_s({1.0, 2.0}, 77.0), glm::dvec2(3.0, -1.0));
  EXPECT_NEAR(wind.drift_m(10.0).x, 30.0, 1e-12);
  EXPECT_NEAR(wind.drift_m(-10.0).y, 10.0, 1e-12);
  EXPECT_EQ(MeanWind().velocity_m_per_s({}, 5.0), glm::dvec2(0.0));
}

TEST(MeanWindTest, ReplayReproducesTheSeries) {
  const WindSeries series = wavering_series();
  const MeanWind wind(series);
  for (std::size_t n = 0; n < series.times_s.size(); ++n) {
    const glm::dvec2 w = wind.velocity_m_per_s(series.place_m, series.times_s[n]);
    EXPECT_NEAR(std::hypot(w.x, w.y), series.speeds_m_per_s[n], 1e-5);
    EXPECT_NEAR(std::remainder(std::atan2(w.y, w.x) - series.headings_rad[n], 6.283185307179586), 0.0, 2e-6);
  }
  const glm::dvec2 early = wind.velocity_m_per_s(series.place_m, 0.0),
                   first = wind.velocity_m_per_s(series.place_m, 100.0);
  EXPECT_EQ(early, first) << "before the first sample";
}

TEST(MeanWindTest, DriftIsTheIntegral) {
  const WindSeries series = wavering_series();
  const MeanWind wind(series);
  glm::dvec2 sum = wind.drift_m(90.0);
  constexpr double kStepS = 0.001;
  for (int n = 0; n < 200000; ++n)
    sum += kStepS * wind.velocity_m_per_s(series.place_m, 90.0 + kStepS * (n + 0.5));
  const glm::dvec2 drift = wind.drift_m(290.0);
  EXPECT_NEAR(drift.x, sum.x, 1e-3);
  EXPECT_NEAR(drift.y, sum.y, 1e-3);
  EXPECT_EQ(wind.drift_m(0.0), glm::dvec2(0.0));
}

TEST(MeanWindTest, GustsTravel) {
  WindSeries series;
  for (int n = 0; n <= 1000; ++n) {
    series.times_s.push_back(0.1 * n);
    series.speeds_m_per_s.push_back(n == 500 ? 9.0 : 5.0);
    series.headings_rad.push_back(0.0);
  }
  const MeanWind wind(series);
  const double mean_speed = wind.drift_m(100.0).x / 100.0;
  EXPECT_NEAR(wind.velocity_m_per_s({20.0, 7.0}, 50.0 + 20.0 / mean_speed).x, 9.0, 1e-5);
  EXPECT_NEAR(wind.velocity_m_per_s({20.0, 7.0}, 50.0).x, 5.0, 1e-5);
}

TEST(MeanWindTest, OneThatFollowsLeavesNoGapInTheDrift) {
  const MeanWind before(glm::dvec2(5.0, 1.0));
  MeanWind after(glm::dvec2(-2.0, 3.0));
  after.follow(before, 40.0);
  EXPECT_NEAR(glm::length(after.drift_m(40.0) - before.drift_m(40.0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(after.drift_m(41.0) - after.drift_m(40.0) - glm::dvec2(-2.0, 3.0)), 0.0, 1e-9);
}

TEST(MeanWindTest, RefusesBadSeries) {
  const auto refused = [](auto change, const std::string& field) {
    WindSeries series = wavering_series();
    change(series);
    try {
      MeanWind{series};
      ADD_FAILURE() << field << " was accepted";
    } catch (const BadInput& fault) {
      EXPECT_NE(std::string(fault.what()).find(field), std::string::npos) << fault.what();
    }
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  refused([](WindSeries& series) { series.times_s[7] = series.times_s[6]; }, "sample 7: time_s");
  refused([](WindSeries& series) { series.times_s[7] = 0.0; }, "sample 7: time_s");
  refused([](WindSeries& series) { series.times_s[9] = kNan; }, "sample 9: time_s");
  refused([](WindSeries& series) { series.speeds_m_per_s[3] = -0.5; }, "sample 3: speed_m_per_s");
  refused([](WindSeries& series) { series.speeds_m_per_s[3] = kNan; }, "sample 3: speed_m_per_s");
  refused([](WindSeries& series) { series.headings_rad[0] = kNan; }, "sample 0: heading_rad");
  refused([](WindSeries& series) { series.headings_rad.pop_back(); }, "299 headings");
  refused([](WindSeries& series) { series = {}; }, "wind series");
  refused([](WindSeries& series) { series.place_m.x = kNan; }, "place_m");
  EXPECT_THROW(MeanWind(glm::dvec2(kNan, 0.0)), BadInput);
  EXPECT_THROW(MeanWind(glm::dvec2(1000.0, 0.0)), BadInput);
}

/// A windy half hour at 10 Hz, where PRAIRIE_DATA names the folder that holds it.
TEST(MeanWindTest, ReplaysAMeasuredHalfHour) {
  const char* folder = std::getenv("PRAIRIE_DATA");
  if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of measured winds";
  const auto path = std::filesystem::path(folder) / "wind_finse_10hz" / "2018-07-20T140000.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "PRAIRIE_DATA holds no wind_finse_10hz";
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  WindSeries series;
  std::vector<glm::dvec2> measured;
  while (std::getline(file, line)) {
    std::stringstream cells(line);
    std::string stamp, u, v;
    std::getline(cells, stamp, ',');
    std::getline(cells, u, ',');
    std::getline(cells, v, ',');
    measured.emplace_back(std::stod(u), std::stod(v));
    series.times_s.push_back(0.1 * static_cast<double>(measured.size() - 1));
    series.speeds_m_per_s.push_back(std::hypot(measured.back().x, measured.back().y));
    series.headings_rad.push_back(std::atan2(measured.back().y, measured.back().x));
  }
  ASSERT_EQ(measured.size(), 18000u);
  const MeanWind wind(series);
  double worst = 0.0, speed = 0.0;
  for (std::size_t n = 0; n < measured.size(); ++n) {
    const glm::dvec2 w = wind.velocity_m_per_s({0.0, 0.0}, series.times_s[n]);
    worst = std::max({worst, std::abs(w.x - measured[n].x), std::abs(w.y - measured[n].y)});
    speed += std::hypot(w.x, w.y) / 18000.0;
  }
  std::printf("replay differs from the series by at most %.1e m/s; mean speed %.2f m/s\n", worst, speed);
  EXPECT_LT(worst, 1e-4);
  const glm::dvec2 drift = wind.drift_m(series.times_s.back());
  EXPECT_NEAR(std::hypot(drift.x, drift.y) / 1799.9, 6.94, 0.1);
}

}  // namespace
}  // namespace prairie
