#include "agents/foot_treads.h"

#include <algorithm>

#include "agents/skeleton.h"

namespace prairie {
namespace {

// A shoe, and the shin above it, push aside more than they stand on.
constexpr double kPressedRadiusM = 0.11;
constexpr double kRolledAt = 0.3;      // share of the stance at which all of the sole has pressed
constexpr double kStandsBelow = 0.05;  // m/s

double rolled(double stance_share) {
  return std::clamp(stance_share / kRolledAt, 0.0, 1.0);
}

}  // namespace

void add_foot_treads(const Footing& before, const Footing& after, std::uint32_t first_id,
                     std::vector<TreadStep>& steps) {
  for (std::uint32_t n = 0; n < kTreadIdsPerWalker; ++n) {
    const Foot& was = before.feet[n];
    const Foot& is = after.feet[n];
    if (!is.planted) continue;
    const double radius_m = kPressedRadiusM * after.scale;
    const auto place_m = [&](double share) {
      const double ahead_m = share * kTipAheadM - (1.0 - share) * kHeelBehindM;
      return is.position_m + ahead_m * after.scale * is.forward;
    };
    const double from = was.planted && was.position_m == is.position_m ? rolled(was.share) : 0.0;
    const double to = rolled(is.share);
    if (to > from) {
      steps.push_back({first_id + n, place_m(from), place_m(to), radius_m, 1.0});
    } else if (after.speed_m_per_s < kStandsBelow) {
      const glm::dvec2 middle_m = place_m(0.5);
      steps.push_back({first_id + n, middle_m, middle_m, radius_m, 1.0});
    }
  }
}

}  // namespace prairie
