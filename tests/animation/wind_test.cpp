// The sum of winds, at a place and at nodes.
#include "animation/wind.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <chrono>

namespace prairie {
namespace {

Wind windy_scene() {
  Wind wind;
  wind.mean = MeanWind(glm::dvec2(4.0, 2.0));
  wind.noise.emplace(NoiseWindSettings{});
  wind.primitives = {Gust{.heading_rad = 0.4, .start_s = 0.0}, Tornado{.origin_m = {20.0, -10.0}},
                     Breeze{.origin_m = {0.0, 0.0}, .radius_m = 30.0}, Breeze{}, Gust{.start_s = 1000.0}};
  wind.wake.emplace(CameraWakeSettings{});
  for (int n = 0; n <= 60; ++n) wind.wake->step({0.1 * n, 0.0}, n / 60.0);
  return wind;
}

TEST(WindTest, NodesHoldWhatPlacesHave) {
  const Wind wind = windy_scene();
  for (const double time_s : {0.5, 8.0, 30.0}) {
    const WindNodes nodes = wind_nodes_around({3.3, -7.9}, 64, 1.0);
    std::vector<glm::vec2> values(64 * 64);
    fill_wind(wind, nodes, time_s, values);
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) {
        const glm::dvec2 place_m(nodes.south_west.i + column, nodes.south_west.j + row);
        ASSERT_EQ(values[static_cast<std::size_t>(row * 64 + column)], wind_m_per_s(wind, place_m, time_s))
            << place_m.x << ' ' << place_m.y << ' ' << time_s;
      }
    }
  }
}

TEST(WindTest, IsTheSumOfItsParts) {
  Wind wind = windy_scene();
  const glm::dvec2 place_m(12.0, -4.0);
  const glm::vec2 all = wind_m_per_s(wind, place_m, 8.0);
  glm::vec2 parts(0.0f);
  for (const WindPrimitive& primitive : wind.primitives) parts += velocity_m_per_s(primitive, place_m, 8.0);
  wind.primitives.clear();
  const glm::vec2 rest = wind_m_per_s(wind, place_m, 8.0);
  EXPECT_NEAR(all.x, rest.x + parts.x, 1e-5f);
  EXPECT_NEAR(all.y, rest.y + parts.y, 1e-5f);
  EXPECT_EQ(wind_m_per_s(Wind{}, place_m, 8.0), glm::vec2(0.0f)) << "calm";
}

TEST(WindTest, NodesFollowTheCentreNodeByNode) {
  const WindNodes here = wind_nodes_around({0.2, 0.2}, 64, 1.0),
                  near = wind_nodes_around({0.45, -0.4}, 64, 1.0);
  EXPECT_EQ(here.south_west, near.south_west);
  EXPECT_EQ(wind_nodes_around({1.2, 0.2}, 64, 1.0).south_west.i, here.south_west.i + 1);
}

TEST(WindTest, AnyNumberOfThreads) {
  const Wind wind = windy_scene();
  const WindNodes nodes = wind_nodes_around({0.0, 0.0}, 64, 1.0);
  const auto filled = [&](std::size_t threads) {
    oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    std::vector<glm::vec2> values(64 * 64);
    fill_wind(wind, nodes, 5.0, values);
    return values;
  };
  EXPECT_EQ(filled(1), filled(2));
  EXPECT_EQ(filled(1), filled(7));
}

/// Measured, not held to a bound: the machine that runs the suite may be busy.
TEST(WindTest, FillsNodesQuickly) {
  const Wind wind = windy_scene();
  const WindNodes nodes = wind_nodes_around({0.0, 0.0}, 64, 1.0);
  std::vector<glm::vec2> values(64 * 64);
  const auto start = std::chrono::steady_clock::now();
  constexpr int kTimes = 100;
  for (int n = 0; n < kTimes; ++n) fill_wind(wind, nodes, 0.1 * n, values);
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / kTimes;
  std::printf("64 × 64 nodes of wind: %.2f ms\n", ms);
  EXPECT_LT(ms, 50.0);
}

}  // namespace
}  // namespace prairie
