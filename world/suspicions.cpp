#include "world/suspicions.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "agents/footprint.h"
#include "agents/obstacle.h"

namespace prairie {
namespace {

double beside_ground_m(glm::dvec2 place_m, glm::dvec2 extent_m) {
  return glm::length(place_m - glm::clamp(place_m, glm::dvec2(0.0), extent_m));
}

std::string beside(const std::string& what, glm::dvec2 place_m, double off_m, glm::dvec2 extent_m) {
  return fmt::format(
      "{} lies at ({:.6g}, {:.6g}) m, {:.3g} m beside the ground, (0, 0) to ({:.6g}, {:.6g}) m; places "
      "count from the ground's south-west corner",
      what, place_m.x, place_m.y, off_m, extent_m.x, extent_m.y);
}

/// Share of a map's area that lies on the ground.
double share_on_ground(const GridFrame& frame, glm::dvec2 extent_m) {
  const glm::dvec2 far_m = frame.far_corner_m(), size_m = far_m - frame.origin_m;
  const glm::dvec2 common_m = glm::min(far_m, extent_m) - glm::max(frame.origin_m, glm::dvec2(0.0));
  if (!(size_m.x > 0.0 && size_m.y > 0.0)) return 1.0;
  return std::max(common_m.x, 0.0) * std::max(common_m.y, 0.0) / (size_m.x * size_m.y);
}

class Suspicions {
 public:
  Suspicions(const Scene& scene, const Meadow& meadow)
      : scene_(scene), extent_m_(meadow.extent_m), standing_(footprints_of(scene.standing, meadow.ground)) {}

  void look_at_walkers() {
    for (const GoalSpec& spec : scene_.goals) {
      const Goal& goal = spec.goal;
      const std::string name = "goal." + spec.name;
      if (const double off_m = beside_ground_m(goal.position_m, extent_m_) - goal.radius_m; off_m > 0.0)
        add("beside-ground", beside(name, goal.position_m, off_m, extent_m_));
      const bool is_inside = std::ranges::any_of(standing_, [&](const Footprint& thing) {
        return plan_distance({goal.position_m, 0.0}, thing).distance_m < -goal.radius_m;
      });
      if (is_inside) {
        add("inside-something",
            fmt::format(
                "{} lies at ({:.6g}, {:.6g}) m, inside an obstacle or a wall: nobody gets there; move it, or "
                "give it a larger radius_m than {:.3g}",
                name, goal.position_m.x, goal.position_m.y, goal.radius_m));
      }
    }
    for (const WalkerGroup& group : scene_.walkers) {
      std::vector<glm::dvec2> starts_m = group.starts_m;
      if (starts_m.empty()) starts_m.push_back(group.centre_m);
      const double reach_m = group.starts_m.empty() ? group.radius_m : 0.0;
      for (const glm::dvec2 start_m : starts_m) {
        const double off_m = beside_ground_m(start_m, extent_m_) - reach_m;
        if (off_m > 0.0) {
          add("beside-ground", beside("walkers." + group.name + ": a start", start_m, off_m, extent_m_));
          break;
        }
      }
    }
  }

  void look_at_movers() {
    for (const MoverSpec& mover : scene_.movers) {
      const auto& path_m = mover.path.path_m;
      const bool comes_onto_it = std::ranges::any_of(
          path_m, [&](glm::dvec2 at_m) { return beside_ground_m(at_m, extent_m_) == 0.0; });
      if (comes_onto_it || path_m.empty()) continue;
      add("beside-ground", beside("mover." + mover.name + ": all of its path", path_m.front(),
                                  beside_ground_m(path_m.front(), extent_m_), extent_m_));
    }
  }

  void look_at_maps(const std::vector<LoadedMap>& maps) {
    constexpr double kHardly = 0.25;
    for (const LoadedMap& map : maps) {
      if (map.frame.repeats) continue;
      const double share = share_on_ground(map.frame, extent_m_);
      if (share >= kHardly) continue;
      add("larger-than-ground", fmt::format("{}: {}: only {:.2g} % of it lies on the ground, (0, 0) to "
                                            "({:.6g}, {:.6g}) m; is its spacing_m, {:.6g}, "
                                            "right?",
                                            map.file.string(), map.field, 100.0 * share, extent_m_.x,
                                            extent_m_.y, map.frame.spacing_m));
    }
  }

  std::vector<Warning> release() { return std::move(warnings_); }

 private:
  void add(const char* code, std::string text) { warnings_.push_back({code, std::move(text)}); }

  const Scene& scene_;
  glm::dvec2 extent_m_;
  std::vector<Footprint> standing_;
  std::vector<Warning> warnings_;
};

}  // namespace

std::vector<Warning> suspicions_of(const Scene& scene, const Meadow& meadow,
                                   const std::vector<LoadedMap>& maps) {
  if (meadow.repeats) return {};
  Suspicions suspicions(scene, meadow);
  suspicions.look_at_walkers();
  suspicions.look_at_movers();
  suspicions.look_at_maps(maps);
  return suspicions.release();
}

}  // namespace prairie
