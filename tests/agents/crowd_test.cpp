#include "agents/crowd.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "files/error.h"
#include "tests/agents/crowd_scene.h"

namespace prairie {
namespace {

constexpr double kStepS = 1.0 / 30.0;

/// Distance from a place to a polygon's edges; negative inside. Written without GJK.
double signed_distance_m(glm::dvec2 place_m, const std::vector<glm::dvec2>& ring_m) {
  double nearest_m = 1e30;
  bool is_inside = false;
  for (std::size_t n = 0, last = ring_m.size() - 1; n < ring_m.size(); last = n++) {
    const glm::dvec2 a = ring_m[last], b = ring_m[n], edge = b - a;
    const double t = std::clamp(glm::dot(place_m - a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    nearest_m = std::min(nearest_m, glm::distance(place_m, a + t * edge));
    if ((a.y > place_m.y) != (b.y > place_m.y) &&
        place_m.x < (b.x - a.x) * (place_m.y - a.y) / (b.y - a.y) + a.x)
      is_inside = !is_inside;
  }
  return is_inside ? -nearest_m : nearest_m;
}

std::vector<glm::dvec2> hull_ring(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<glm::dvec2> ring;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = ring.size();
    for (const glm::dvec2 p : points) {
      while (ring.size() >= first + 2) {
        const glm::dvec2 u = ring.back() - ring[ring.size() - 2], v = p - ring.back();
        if (u.x * v.y - u.y * v.x > 0.0) break;
        ring.pop_back();
      }
      ring.push_back(p);
    }
    ring.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return ring;
}

/// All that stands: what is drawn, as seen from above.
class Standing {
 public:
  explicit Standing(const CrowdScene& scene) {
    for (const Obstacle& obstacle : scene.obstacles) {
      if (const auto* trunk = std::get_if<Trunk>(&obstacle)) {
        trunks_.push_back(*trunk);
      } else if (const auto* block = std::get_if<Block>(&obstacle)) {
        const PlacedBlock at = placed(*block, scene.ground);
        std::vector<glm::dvec2> corners;
        for (const glm::dvec2 c :
             {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
          corners.push_back(glm::dvec2(at.centre_m + at.axes * (glm::dvec3(c, 0.0) * at.half_size_m)));
        rings_.push_back({corners, 1.0});
      } else {
        const Rock& rock = std::get<Rock>(obstacle);
        const RockFrame frame = placed(rock, scene.ground);
        std::vector<glm::dvec2> points;
        for (const glm::dvec3& v : hull_of(rock).vertices_m)
          points.push_back(glm::dvec2(frame.origin_m + frame.axes * v));
        rings_.push_back({hull_ring(points), 1.0});
      }
    }
    for (const Wall& wall : scene.walls) {
      const double side = wall.walkers == WallSide::kInside ? -1.0 : 1.0;
      rings_.push_back({wall.outline.outer_m, side});
      for (const auto& hole_m : wall.outline.holes_m) rings_.push_back({hole_m, -side});
    }
  }

  double distance_m(glm::dvec2 place_m) const {
    double nearest_m = 1e30;
    for (const Trunk& trunk : trunks_)
      nearest_m = std::min(nearest_m, glm::distance(place_m, trunk.position_m) - trunk.radius_m);
    for (const auto& [ring_m, side] : rings_)
      nearest_m = std::min(nearest_m, side * signed_distance_m(place_m, ring_m));
    return nearest_m;
  }

 private:
  std::vector<Trunk> trunks_;
  std::vector<std::pair<std::vector<glm::dvec2>, double>>
      rings_;  // and 1 where their inside is solid, −1 where it is free
};

struct Walked {
  double least_gap_m = 1e30;       // between bodies and what stands
  double least_centre_m = 1e30;    // of centres
  double deepest_overlap_m = 0.0;  // of two bodies
  double least_way_m = 1e30;       // of anybody, in all
  double longest_stuck_s = 0.0;    // within half a metre
  double worst_d_m = 0.0;          // of perceived distances
  double worst_end_m = 0.0;        // of where perceived directions lead, from the edge of what is drawn
};

Walked walk(const CrowdScene& scene, std::uint64_t seed, double duration_s) {
  Crowd crowd = crowd_of(scene, 100, seed);
  const std::size_t count = crowd.walkers().size();
  std::vector<double> way_m(count, 0.0), since_s(count, 0.0);
  std::vector<glm::dvec2> anchor_m, last_m;
  for (const Walker& walker : crowd.walkers()) anchor_m.push_back(walker.position_m);
  last_m = anchor_m;
  Walked walked;
  const Standing standing(scene);
  const auto steps = static_cast<int>(std::lround(duration_s / kStepS));
  for (int n = 0; n < steps; ++n) {
    const double time_s = n * kStepS;
    crowd.step({scene.ground, {}, {}}, time_s, kStepS, 0);
    for (std::size_t a = 0; a < count; ++a) {
      const Walker& walker = crowd.walkers()[a];
      way_m[a] += glm::distance(walker.position_m, last_m[a]);
      last_m[a] = walker.position_m;
      if (glm::distance(walker.position_m, anchor_m[a]) > 0.5) {
        anchor_m[a] = walker.position_m;
        since_s[a] = time_s;
      }
      walked.longest_stuck_s = std::max(walked.longest_stuck_s, time_s - since_s[a]);
      for (std::size_t b = 0; b < a; ++b) {
        const double overlap_m = crowd.traits()[a].radius_m + crowd.traits()[b].radius_m -
                                 glm::distance(walker.position_m, crowd.walkers()[b].position_m);
        walked.deepest_overlap_m = std::max(walked.deepest_overlap_m, overlap_m);
      }
    }
    if (n % 10 != 0) continue;
    const std::vector<Percept> percepts = crowd.percepts({});
    for (std::size_t a = 0; a < count; ++a) {
      const glm::dvec2 place_m = crowd.walkers()[a].position_m;
      const double radius_m = crowd.traits()[a].radius_m, standing_m = standing.distance_m(place_m);
      walked.least_centre_m = std::min(walked.least_centre_m, standing_m);
      walked.least_gap_m = std::min(walked.least_gap_m, standing_m - radius_m);
      double nearest_m = standing_m - radius_m;
      for (std::size_t b = 0; b < count; ++b) {
        if (b == a) continue;
        nearest_m = std::min(nearest_m, glm::distance(place_m, crowd.walkers()[b].position_m) - radius_m -
                                            crowd.traits()[b].radius_m);
      }
      nearest_m = std::min(nearest_m, crowd.traits()[a].sensor_m);
      walked.worst_d_m = std::max(walked.worst_d_m, std::abs(nearest_m - percepts[a].distance_m));
      if (percepts[a].kind == Percept::Kind::kNothing) continue;
      const glm::dvec2 end_m = place_m + (radius_m + percepts[a].distance_m) * percepts[a].toward;
      double off_m = std::abs(standing.distance_m(end_m));
      for (std::size_t b = 0; b < count; ++b) {
        if (b == a) continue;
        off_m = std::min(off_m, std::abs(glm::distance(end_m, crowd.walkers()[b].position_m) -
                                         crowd.traits()[b].radius_m));
      }
      walked.worst_end_m = std::max(walked.worst_end_m, off_m);
    }
  }
  walked.least_way_m = *std::min_element(way_m.begin(), way_m.end());
  return walked;
}

void expect_nobody_walks_through(std::uint64_t seed) {
  const Walked walked = walk(crowd_scene(), seed, 600.0);
  fmt::print(
      "seed {}: least gap {:.5f} m, centre {:.3f} m, overlap {:.6f} m, least way {:.0f} m, longest stuck "
      "{:.1f} s, d off by {:.1e} m, its end by {:.1e} m\n",
      seed, walked.least_gap_m, walked.least_centre_m, walked.deepest_overlap_m, walked.least_way_m,
      walked.longest_stuck_s, walked.worst_d_m, walked.worst_end_m);
  EXPECT_GT(walked.least_centre_m, 0.0);
  EXPECT_GT(walked.least_gap_m, 0.0);
  EXPECT_LE(walked.deepest_overlap_m, 0.02);
  EXPECT_GE(walked.least_way_m, 100.0);
  EXPECT_LE(walked.longest_stuck_s, 20.0);
  EXPECT_LE(walked.worst_d_m, 1e-4);
  EXPECT_LE(walked.worst_end_m, 1e-4);
}

class CrowdTest : public testing::TestWithParam<int> {};
class CrowdLongTest : public testing::TestWithParam<int> {};

TEST_P(CrowdTest, NobodyWalksThroughAnything) {
  expect_nobody_walks_through(static_cast<std::uint64_t>(GetParam()));
}
TEST_P(CrowdLongTest, NobodyWalksThroughAnything) {
  expect_nobody_walks_through(static_cast<std::uint64_t>(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Seeds, CrowdTest, testing::Range(1, 4));
INSTANTIATE_TEST_SUITE_P(Seeds, CrowdLongTest, testing::Range(4, 21));

TEST(CrowdStepTest, IsTheSameForAnyNumberOfThreads) {
  const CrowdScene scene = crowd_scene();
  std::vector<std::vector<Walker>> ends;
  for (const std::size_t threads : {1u, 2u, 5u}) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    Crowd crowd = crowd_of(scene, 60, 11);
    for (int n = 0; n < 300; ++n) crowd.step({scene.ground, {}, {}}, n * kStepS, kStepS, 0);
    ends.emplace_back(crowd.walkers().begin(), crowd.walkers().end());
  }
  EXPECT_TRUE(ends[0] == ends[1]);
  EXPECT_TRUE(ends[0] == ends[2]);
}

}  // namespace
}  // namespace prairie
