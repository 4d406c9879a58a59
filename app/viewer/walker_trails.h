// Where walkers were in the last minute, for lines behind them. Kept are only those next to the eye, so that
// it takes a few megabytes at most, however many walk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>
#include <vector>

namespace prairie {

class World;

/// With more than these, the nearest ones.
inline constexpr std::size_t kMostOverlaidWalkers = 200;

/// Where a walker stands.
glm::dvec3 on_ground_m(const World& world, std::size_t walker);

/// The walkers present that are nearest to the eye as seen from above, at most `most`; ascending.
std::vector<std::uint32_t> nearest_walkers(const World& world, glm::dvec3 eye_m, std::size_t most);

class WalkerTrails {
 public:
  static constexpr double kLengthS = 60.0;
  static constexpr double kIntervalS = 0.25;

  struct Place {
    std::uint32_t walker = 0;
    glm::dvec3 on_ground_m{0.0};

    bool operator==(const Place&) const = default;
  };
  /// Places ascend by walker.
  struct Sample {
    double time_s = 0.0;
    std::vector<Place> places;
  };

  /// Takes a sample of whom the eye has around it where the last one is old enough, and drops those that are
  /// too old; all of them where time went back.
  void follow(const World& world, glm::dvec3 eye_m);

  /// From the oldest on.
  const std::deque<Sample>& samples() const { return samples_; }

 private:
  std::deque<Sample> samples_;
};

}  // namespace prairie
