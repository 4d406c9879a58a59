#include "animation/standing_blade.h"

#include <algorithm>
#include <cmath>

namespace prairie {

StandingBlade standing_blade(const Surroundings& around, TileId tile, const CellTables& tables, const PlantedCell& cell,
                             const Blade& blade) {
  Kernels kernels{tables.tables.data()};
  StandingBlade found;
  found.blade = blade;
  found.species = &around.species[cell.species];
  found.place_m = tile_origin_m(around.meadow, tile) + glm::dvec2(found.blade.root_m);
  const glm::vec2 slope =
      kernels.ground_in_cell(cell.ground_table, cell.side_m, found.blade.root_m - cell.offset_m).slope;
  found.normal = kernels.normalized(glm::vec3(-slope.x, -slope.y, 1.0f));

  const Tread tread = around.treading.sample(found.place_m);
  Kernels::Pressing pressing{tread.lean_rad, tread.tilt_rad, tread.wear};
  found.blade.height_m *= kernels.worn_length(tread.wear);
  const Kernels::BladeCurve grown = kernels.pose_blade(found.blade, slope, 1.0f);
  ChainVectors load{};
  if (around.sway != nullptr) {
    const VirtualTexel texel = around.sway->at(cell.species, found.place_m);
    const auto& t = texel.segments;
    const double periods = around.time_s / static_cast<double>(layouts::kSwayPeriodS);
    load = kernels.with_own_sway(found.blade, grown, kernels.texel_load(t[0], t[1], t[2], t[3]),
                                 kernels.texel_tip(t[0], t[1], t[2]), static_cast<float>(periods - std::floor(periods)));
  }
  found.curve = kernels.pressed_curve(grown, found.blade.height_m, found.normal, pressing);
  found.least_rise = kernels.lowest_rise(kernels.lying_share(pressing));
  found.rest = kernels.chain_rest(found.curve).along;
  // A blade's own swaying keeps its pace: a change of frequency would throw it out of its phase.
  found.stiffness = found.blade.stiffness;
  if (around.conditions != nullptr) found.stiffness *= around.conditions->at(found.place_m).stiffness_factor;
  found.virtual_turn =
      kernels.virtual_turns(found.rest, load, 1.0f / std::max(found.stiffness, kernels.softest_chain()));
  return found;
}

}  // namespace prairie
