#include "animation/standing_blade.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "generator/vector_stage.h"

namespace prairie {
namespace {

constexpr std::size_t kTogether = ChainBlock::kBlades;
using Row = ChainBlock::Row;

/// Blades as the processor likes them: what makes each stand as it does, and how that is.
struct StandingBlock {
  Row root_m[2], ground_m, height_m, azimuth_rad, tilt_rad, curvature_rad, lean[2], own_stiffness,
      phase_rad;            // as worn
  Row slope[2], normal[3];  // of the ground
  Row tread[3];             // lean east, lean north, tilt
  Row load[12], tip[3];     // of the virtual blade's texel; 0 in calm air
  Row stiffness;            // in the condition that it is in
  Row curve[12], side[3], rest[12], turn[12], least_rise;
};

Blade blade_in(const StandingBlock& block, std::size_t n) {
  Blade blade{};
  blade.root_m = {block.root_m[0][n], block.root_m[1][n]};
  blade.ground_m = block.ground_m[n];
  blade.height_m = block.height_m[n];
  blade.azimuth_rad = block.azimuth_rad[n];
  blade.tilt_rad = block.tilt_rad[n];
  blade.curvature_rad = block.curvature_rad[n];
  blade.lean = {block.lean[0][n], block.lean[1][n]};
  blade.stiffness = block.own_stiffness[n];
  blade.phase_rad = block.phase_rad[n];
  return blade;
}

void put_blade(StandingBlock& block, std::size_t n, const Blade& blade) {
  for (int axis = 0; axis < 2; ++axis) {
    block.root_m[axis][n] = blade.root_m[axis];
    block.lean[axis][n] = blade.lean[axis];
  }
  block.ground_m[n] = blade.ground_m;
  block.height_m[n] = blade.height_m;
  block.azimuth_rad[n] = blade.azimuth_rad;
  block.tilt_rad[n] = blade.tilt_rad;
  block.curvature_rad[n] = blade.curvature_rad;
  block.own_stiffness[n] = blade.stiffness;
  block.phase_rad[n] = blade.phase_rad;
}

glm::vec3 vector_in(const Row* rows, std::size_t n) {
  return {rows[0][n], rows[1][n], rows[2][n]};
}

void put_vector(Row* rows, std::size_t n, glm::vec3 v) {
  rows[0][n] = v.x;
  rows[1][n] = v.y;
  rows[2][n] = v.z;
}

/// `time`: the share of kSwayPeriodS that has passed.
PRAIRIE_VECTOR_STAGE void pose_block(StandingBlock& block, float time) {
  for (std::size_t n = 0; n < kTogether; ++n) {
    Kernels kernels;
    const Blade blade = blade_in(block, n);
    const Kernels::Pressing pressing{{block.tread[0][n], block.tread[1][n]}, block.tread[2][n], 0.0f};
    const Kernels::BladeCurve grown = kernels.pose_blade(blade, {block.slope[0][n], block.slope[1][n]}, 1.0f);
    const ChainVectors load =
        kernels.with_own_sway(blade, grown, vectors_in(block.load, n), vector_in(block.tip, n), time);
    const Kernels::BladeCurve curve =
        kernels.pressed_curve(grown, blade.height_m, vector_in(block.normal, n), pressing);
    const ChainVectors rest = kernels.chain_rest(curve).along;
    const float compliance = 1.0f / std::max(block.stiffness[n], kernels.softest_chain());
    put_vectors(block.turn, n, kernels.virtual_turns(rest, load, compliance));
    put_vectors(block.rest, n, rest);
    put_vectors(block.curve, n, {curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m});
    put_vector(block.side, n, curve.side);
    block.least_rise[n] = kernels.lowest_rise(kernels.lying_share(pressing));
  }
}

void take_from(const StandingBlock& block, std::size_t n, StandingBlade& found) {
  const ChainVectors curve = vectors_in(block.curve, n);
  found.curve = {curve.v1, curve.v2, curve.v3, curve.v4, vector_in(block.side, n)};
  found.rest = vectors_in(block.rest, n);
  found.virtual_turn = vectors_in(block.turn, n);
  found.least_rise = block.least_rise[n];
}

void find_block(const Surroundings& around, TileId tile, const CellTables& tables,
                std::span<const BladeOfCell> blades, std::span<StandingBlade> found) {
  Kernels kernels{tables.tables.data()};
  std::array<glm::dvec2, kTogether> places_m;
  std::array<Tread, kTogether> treads;
  const glm::dvec2 origin_m = tile_origin_m(around.meadow, tile);
  for (std::size_t n = 0; n < blades.size(); ++n)
    places_m[n] = origin_m + glm::dvec2(blades[n].blade->root_m);
  around.treading.sample(std::span(places_m).first(blades.size()), std::span(treads).first(blades.size()));

  StandingBlock block{};
  // What does not count here is posed, too, and must be a blade.
  for (Row* row : {&block.height_m, &block.own_stiffness, &block.stiffness})
    std::fill_n(*row, kTogether, 1.0f);
  for (std::size_t n = 0; n < blades.size(); ++n) {
    const PlantedCell& cell = *blades[n].cell;
    StandingBlade& now = found[n];
    now.blade = *blades[n].blade;
    now.species = &around.species[cell.species];
    now.place_m = places_m[n];
    now.blade.height_m *= kernels.worn_length(treads[n].wear);
    const glm::vec2 slope =
        kernels.ground_in_cell(cell.ground_table, cell.side_m, now.blade.root_m - cell.offset_m).slope;
    now.normal = kernels.normalized(glm::vec3(-slope.x, -slope.y, 1.0f));
    // A blade's own swaying keeps its pace: a change of frequency would throw it out of its phase.
    now.stiffness = now.blade.stiffness;
    if (around.conditions != nullptr) now.stiffness *= around.conditions->at(now.place_m).stiffness_factor;

    put_blade(block, n, now.blade);
    for (int axis = 0; axis < 2; ++axis) block.slope[axis][n] = slope[axis];
    put_vector(block.normal, n, now.normal);
    put_vector(block.tread, n, {treads[n].lean_rad, treads[n].tilt_rad});
    block.stiffness[n] = now.stiffness;
    if (around.sway != nullptr) {
      const auto& t = around.sway->at(cell.species, now.place_m).segments;
      put_vectors(block.load, n, kernels.texel_load(t[0], t[1], t[2], t[3]));
      put_vector(block.tip, n, kernels.texel_tip(t[0], t[1], t[2]));
    }
  }
  const double periods = around.time_s / static_cast<double>(layouts::kSwayPeriodS);
  pose_block(block, static_cast<float>(periods - std::floor(periods)));
  for (std::size_t n = 0; n < blades.size(); ++n) take_from(block, n, found[n]);
}

}  // namespace

void find_standing(const Surroundings& around, TileId tile, const CellTables& tables,
                   std::span<const BladeOfCell> blades, std::span<StandingBlade> found) {
  assert(blades.size() == found.size());
  for (std::size_t first = 0; first < blades.size(); first += kTogether) {
    const std::size_t count = std::min(kTogether, blades.size() - first);
    find_block(around, tile, tables, blades.subspan(first, count), found.subspan(first, count));
  }
}

}  // namespace prairie
