#include "app/outputs/trajectory_table.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "world/world.h"

namespace prairie {

std::string trajectory_header() {
  return "time_s,id,x_m,y_m,z_m,heading_rad,speed_m_per_s,d_m,theta_rad,left_planted,right_planted\n";
}

std::string trajectory_rows(const World& world) {
  std::string text;
  const std::vector<Percept> percepts = world.percepts();
  const std::span<const Walker> walkers = world.walkers();
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    if (!world.is_present(n)) continue;
    const Walker& walker = walkers[n];
    const glm::dvec2 f = walker.forward;
    text += fmt::format("{:.6f},{},{:.6f},{:.6f},{:.4f},{:.6f},{:.4f},", world.time_s(),
                        world.walker_traits()[n].id, walker.position_m.x, walker.position_m.y,
                        world.meadow().ground.height_m(walker.position_m), std::atan2(f.y, f.x),
                        walker.speed_m_per_s);
    if (n < percepts.size() && percepts[n].kind != Percept::Kind::kNothing) {
      const glm::dvec2 t = percepts[n].toward;
      text += fmt::format("{:.6f},{:.6f}", percepts[n].distance_m,
                          std::atan2(f.x * t.y - f.y * t.x, glm::dot(f, t)));
    } else {
      text += ',';
    }
    text += fmt::format(",{:d},{:d}\n", walker.footing.feet[0].planted, walker.footing.feet[1].planted);
  }
  return text;
}

}  // namespace prairie
