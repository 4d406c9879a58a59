#include "animation/touched_blades.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "animation/blade_checks.h"
#include "animation/contact.h"
#include "files/error.h"
#include "generator/plant_cell.h"

namespace prairie {
namespace {

// A tip goes back to the virtual blade by no more than this share of its length in a second.
constexpr float kFadePerS = 0.28f;
// Nearer to a solid a root is under it, as for bend_out.
constexpr double kUnderM = 2e-3;

constexpr std::int32_t kFaded = 2;

struct Disc {
  glm::dvec2 centre_m;
  double radius_m;
};

Disc footprint(const Solid& solid) {
  if (const auto* sphere = std::get_if<Sphere>(&solid))
    return {glm::dvec2(sphere->centre_m), sphere->radius_m};
  if (const auto* capsule = std::get_if<Capsule>(&solid)) {
    const glm::dvec2 from_m(capsule->from_m), to_m(capsule->to_m);
    return {0.5 * (from_m + to_m), 0.5 * glm::distance(from_m, to_m) + capsule->radius_m};
  }
  const Box& box = std::get<Box>(solid);
  return {glm::dvec2(box.centre_m), glm::length(box.half_size_m)};
}

Solid moved(const Solid& solid, glm::dvec3 by_m) {
  Solid result = solid;
  if (auto* sphere = std::get_if<Sphere>(&result)) sphere->centre_m += by_m;
  if (auto* capsule = std::get_if<Capsule>(&result)) {
    capsule->from_m += by_m;
    capsule->to_m += by_m;
  }
  if (auto* box = std::get_if<Box>(&result)) box->centre_m += by_m;
  return result;
}

ChainVectors plus(const ChainVectors& a, const ChainVectors& b, float scale = 1.0f) {
  return Kernels{}.chain_sum(a, b, scale);
}

// Treads change what a blade rests in, not where it is. They do so little by little: the cross product of two
// directions is the turn between them.
void keep_in_place(const ChainVectors& old_rest, const ChainVectors& new_rest, ChainVectors& turn) {
  turn.v1 -= glm::cross(old_rest.v1, new_rest.v1);
  turn.v2 -= glm::cross(old_rest.v2, new_rest.v2);
  turn.v3 -= glm::cross(old_rest.v3, new_rest.v3);
  turn.v4 -= glm::cross(old_rest.v4, new_rest.v4);
  turn = Kernels{}.within_half_turns(turn);
}

glm::dvec3 tile_base(const Meadow& meadow, TileId tile) {
  return {tile_origin_m(meadow, tile), tile_base_m(meadow, tile)};
}

}  // namespace

bool TouchedBlade::operator==(const TouchedBlade& other) const {
  static_assert(sizeof(TouchedBlade) == 4 * (1 + 24 + 12 + 12 + 1 + 2));
  return std::memcmp(this, &other, sizeof(*this)) == 0;
}

std::size_t TouchedBlades::size() const {
  std::size_t count = 0;
  for (const auto& [id, patch] : patches_) count += patch.touched.size();
  return count;
}

// Finds how many blades of which species there are.
void TouchedBlades::lay_out(const Meadow& meadow, CellId id, Patch& patch) {
  if (!lattice_) lattice_.emplace(meadow);
  append_cell(meadow, *lattice_, id.tile, id.cell, patch.tables);
  std::uint32_t count = 0;
  for (const PlantedCell& cell : patch.tables.cells) {
    patch.first_blade.push_back(count);
    count += cell.planted;
  }
  patch.blade_count = count;
}

// The blades of a patch that is laid out.
void TouchedBlades::plant(const Meadow& meadow, Patch& patch) {
  patch.blades.resize(patch.blade_count);
  for (std::size_t n = 0; n < patch.tables.cells.size(); ++n) {
    const PlantedCell& cell = patch.tables.cells[n];
    plant_cell(cell, meadow.species[cell.species].species.params, patch.tables.tables,
               std::span(patch.blades).subspan(patch.first_blade[n], cell.planted));
  }
}

TouchedBlades::Patch& TouchedBlades::patch_at(const Meadow& meadow, CellId id) {
  const auto [entry, is_new] = patches_.try_emplace(id);
  Patch& patch = entry->second;
  if (!is_new) return patch;
  lay_out(meadow, id, patch);
  plant(meadow, patch);
  return patch;
}

std::vector<StandingBlade> TouchedBlades::standing(const Surroundings& around, CellId id, const Patch& patch,
                                                   std::span<const std::uint32_t> indices) {
  std::vector<BladeOfCell> blades;
  blades.reserve(indices.size());
  for (const std::uint32_t index : indices) {
    const auto after = std::upper_bound(patch.first_blade.begin(), patch.first_blade.end(), index);
    const auto cell = static_cast<std::size_t>(after - patch.first_blade.begin()) - 1;
    blades.push_back({&patch.tables.cells[cell], &patch.blades[index]});
  }
  std::vector<StandingBlade> found(indices.size());
  find_standing(around, id.tile, patch.tables, blades, found);
  return found;
}

void TouchedBlades::stand_touched(const Surroundings& around, CellId id, Patch& patch) {
  std::vector<std::uint32_t> indices;
  indices.reserve(patch.touched.size());
  for (const TouchedBlade& blade : patch.touched) indices.push_back(blade.index);
  patch.standing = standing(around, id, patch, indices);
}

void TouchedBlades::swing(const Surroundings& around, float dt_s) {
  struct Moving {
    CellId id;
    Patch* patch;
    std::size_t first;  // of its chains
  };
  std::vector<Moving> moving;
  std::size_t count = 0;
  for (auto& [id, patch] : patches_) {
    patch.standing.clear();
    if (patch.touched.empty()) continue;
    moving.push_back({id, &patch, count});
    count += patch.touched.size();
  }
  InertialChains chains(count);
  tbb::parallel_for(std::size_t{0}, moving.size(), [&](std::size_t at) {
    auto [id, patch, first] = moving[at];
    stand_touched(around, id, *patch);
    for (std::size_t n = 0; n < patch->touched.size(); ++n) {
      TouchedBlade& blade = patch->touched[n];
      const StandingBlade& now = patch->standing[n];
      keep_in_place(blade.rest, now.rest, blade.motion.turn);
      blade.rest = now.rest;
      ChainTraits traits = *now.species;
      // The same wind bends stiff and soft blades of a species alike, as it does in the virtual model.
      traits.drag *= now.blade.stiffness / traits.stiffness;
      traits.stiffness = now.stiffness;
      traits.half_segment_m = now.blade.height_m / 8.0f;
      chains.plant(first + n, now.rest, traits);
      chains.set_motion(first + n, blade.motion);
      chains.set_wind(first + n, glm::vec3(wind_m_per_s(around.wind, now.place_m, around.time_s), 0.0f));
    }
  });
  chains.step(dt_s);
  tbb::parallel_for(std::size_t{0}, moving.size(), [&](std::size_t at) {
    const auto& [id, patch, first] = moving[at];
    for (std::size_t n = 0; n < patch->touched.size(); ++n)
      patch->touched[n].motion = chains.motion(first + n);
  });
}

namespace {

bool lies_under(std::span<const Solid> solids, glm::vec3 root_m) {
  return std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) {
    return separation(solid, glm::dvec3(root_m)).distance_m < kUnderM;
  });
}

/// Bends a blade out of all solids; whether any touched it.
bool is_bent(std::span<const Solid> solids, const StandingBlade& now, TouchedBlade& blade) {
  TouchedBlade bent = blade;
  const auto bend = [&] {
    bool is_touched = false;
    for (const Solid& solid : solids)
      is_touched |= bend_out(solid, now.blade, now.curve, 1.0f, now.normal, bent.motion, bent.rise);
    return is_touched;
  };
  if (lies_under(solids, now.curve.base_m)) bent.rise = std::min(bent.rise, 0.0f);
  if (!bend()) return false;
  if (bent.rise > 0.0f) {
    // What lies beneath gives way, too.
    bent.rise = 0.0f;
    bend();
  }
  bent.near_steps = 0;
  bent.fades = 0;
  blade = bent;
  return true;
}

}  // namespace

void TouchedBlades::touch(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m) {
  const double cell_m = around.meadow.tile_m / kCellsPerSide;
  const TileRange field = tiles_of(around.meadow);
  double longest_m = 0.0;
  for (const PlantedSpecies& planted : around.meadow.species) {
    const SpeciesParams& params = planted.species.params;
    longest_m = std::max(longest_m, static_cast<double>(params.height_m * (1.0f + layouts::kTallestSpread *
                                                                                      params.height_spread)));
  }
  std::map<CellId, std::vector<const Solid*>> near;
  for (const Solid& solid : solids) {
    const Disc disc = footprint(solid);
    if (glm::distance(disc.centre_m, eye_m) > kReachM) continue;
    const double reach_m = disc.radius_m + longest_m;
    const glm::ivec2 low(glm::floor((disc.centre_m - reach_m) / cell_m)),
        high(glm::floor((disc.centre_m + reach_m) / cell_m));
    for (int j = low.y; j <= high.y; ++j) {
      for (int i = low.x; i <= high.x; ++i) {
        const TileId tile{i >> 1, j >> 1};
        if (!around.meadow.repeats && !field.contains(tile)) continue;
        near[{tile, (i & 1) + 2 * (j & 1)}].push_back(&solid);
      }
    }
  }
  for (auto& [id, patch] : patches_) patch.is_near = false;
  struct Meeting {
    CellId id;
    Patch* patch;
    std::span<const Solid* const> objects;
  };
  std::vector<Meeting> meetings;
  for (const auto& [id, objects] : near) {
    Patch& patch = patch_at(around.meadow, id);
    patch.is_near = true;
    meetings.push_back({id, &patch, objects});
  }
  tbb::parallel_for(std::size_t{0}, meetings.size(), [&](std::size_t n) {
    touch_patch(around, meetings[n].id, *meetings[n].patch, meetings[n].objects);
  });
}

void TouchedBlades::touch_patch(const Surroundings& around, CellId id, Patch& patch,
                                std::span<const Solid* const> objects) const {
  const glm::dvec3 base_m = tile_base(around.meadow, id.tile);
  std::vector<Solid> local;  // in the tile's frame
  for (const Solid* solid : objects) local.push_back(moved(*solid, -base_m));
  const auto may_touch = [&](const Blade& blade) {
    const glm::dvec3 root_m(blade.root_m, blade.ground_m);
    const auto length_m = static_cast<double>(blade.height_m);
    return std::any_of(local.begin(), local.end(),
                       [&](const Solid& solid) { return separation(solid, root_m).distance_m < length_m; });
  };
  // Those that nothing has touched yet.
  std::vector<std::uint32_t> candidates;
  auto known = patch.touched.begin();
  for (std::uint32_t index = 0; index < patch.blade_count; ++index) {
    if (known != patch.touched.end() && known->index == index) {
      ++known;
    } else if (may_touch(patch.blades[index])) {
      candidates.push_back(index);
    }
  }
  const std::vector<StandingBlade> candidates_standing = standing(around, id, patch, candidates);

  // Both together, by index.
  std::vector<TouchedBlade> touched;
  std::vector<StandingBlade> touched_standing;
  std::size_t of_known = 0, of_candidates = 0;
  while (of_known < patch.touched.size() || of_candidates < candidates.size()) {
    const bool is_known =
        of_candidates == candidates.size() ||
        (of_known < patch.touched.size() && patch.touched[of_known].index < candidates[of_candidates]);
    const StandingBlade& now = is_known ? patch.standing[of_known] : candidates_standing[of_candidates];
    TouchedBlade blade;
    if (is_known) {
      blade = patch.touched[of_known++];
    } else {
      blade.index = candidates[of_candidates++];
      blade.rest = now.rest;
      blade.motion.turn = now.virtual_turn;
      blade.rise = now.least_rise;
    }
    const bool is_touched = (!is_known || may_touch(patch.blades[blade.index])) && is_bent(local, now, blade);
    if (!is_touched && !is_known) continue;
    touched.push_back(blade);
    touched_standing.push_back(now);
  }
  patch.touched = std::move(touched);
  patch.standing = std::move(touched_standing);
}

void TouchedBlades::hand_over(float dt_s) {
  for (auto& [id, patch] : patches_) {
    for (std::size_t n = 0; n < patch.touched.size(); ++n) {
      TouchedBlade& blade = patch.touched[n];
      const StandingBlade& now = patch.standing[n];
      const float most = kFadePerS * dt_s;
      blade.rise += std::clamp(now.least_rise - blade.rise, -most, most);
      if (blade.fades != 0) {
        blade.offset = faded(blade.offset, most);
        blade.motion.turn = Kernels{}.within_half_turns(plus(now.virtual_turn, blade.offset));
        blade.motion.rate = ChainVectors{};
        const ChainVectors& o = blade.offset;
        const glm::vec3 left = glm::abs(o.v1) + glm::abs(o.v2) + glm::abs(o.v3) + glm::abs(o.v4);
        if (left == glm::vec3(0.0f) && blade.rise == now.least_rise) blade.fades = kFaded;
        continue;
      }
      SpentMotion spent{blade.near_steps};
      const bool is_spent = spent.watch(tip_gap(now.rest, blade.motion.turn, now.virtual_turn));
      blade.near_steps = spent.near_steps;
      if (!is_spent) continue;
      blade.fades = 1;
      blade.offset = plus(blade.motion.turn, now.virtual_turn, -1.0f);
    }
    std::size_t kept = 0;
    for (std::size_t n = 0; n < patch.touched.size(); ++n) {
      if (patch.touched[n].fades == kFaded) continue;
      patch.touched[kept] = patch.touched[n];
      patch.standing[kept++] = patch.standing[n];
    }
    patch.touched.resize(kept);
    patch.standing.resize(kept);
  }
  std::erase_if(patches_,
                [](const auto& entry) { return entry.second.touched.empty() && !entry.second.is_near; });
}

void TouchedBlades::pose(const Surroundings& around) {
  for (auto& [id, patch] : patches_) stand_touched(around, id, patch);
  make_chains();
}

void TouchedBlades::meet(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m) {
  pose(around);
  touch(around, solids, eye_m);
  make_chains();
}

void TouchedBlades::make_chains() {
  groups_.clear();
  chains_.clear();
  for (const auto& [id, patch] : patches_) {
    if (patch.touched.empty()) continue;
    std::vector<TouchedGroup> groups;
    for (const PlantedCell& cell : patch.tables.cells)
      groups.push_back({cell.key, std::vector<std::uint32_t>(cell.planted, 0)});
    for (std::size_t n = 0; n < patch.touched.size(); ++n) {
      const TouchedBlade& blade = patch.touched[n];
      const StandingBlade& now = patch.standing[n];
      chains_.push_back(now.chain(blade.motion.turn, blade.rise));
      const auto after = std::upper_bound(patch.first_blade.begin(), patch.first_blade.end(), blade.index);
      const auto group = static_cast<std::size_t>(after - patch.first_blade.begin()) - 1;
      groups[group].slots[blade.index - patch.first_blade[group]] =
          static_cast<std::uint32_t>(chains_.size());
    }
    for (TouchedGroup& group : groups) groups_.push_back(std::move(group));
  }
}

void TouchedBlades::step(const Surroundings& around, std::span<const Solid> solids, glm::dvec2 eye_m,
                         float dt_s) {
  swing(around, dt_s);
  hand_over(dt_s);
  touch(around, solids, eye_m);
  make_chains();
}

TouchedState TouchedBlades::state() const {
  TouchedState state;
  for (const auto& [id, patch] : patches_) {
    if (!patch.touched.empty()) state.emplace_back(id, patch.touched);
  }
  return state;
}

void TouchedBlades::restore(const TouchedState& state, const Meadow& meadow) {
  check_state(state, meadow);
  // Counted before they are planted: a made-up state may name any number of cells.
  std::map<CellId, Patch> patches;
  std::size_t blades = 0;
  for (const auto& [id, touched] : state) {
    Patch& patch = patches[id];
    lay_out(meadow, id, patch);
    blades += patch.blade_count;
    if (touched.back().index >= patch.blade_count)
      throw BadInput("", "touched.index", fmt::format("{}", touched.back().index),
                     fmt::format("one of the {} blades of cell {} of tile {}, {}", patch.blade_count, id.cell,
                                 id.tile.i, id.tile.j));
    if (blades > kMostTouchable)
      throw BadInput("", "touched", "cells with more blades",
                     fmt::format("at most {} in all", kMostTouchable));
  }
  for (const auto& [id, touched] : state) {
    Patch& patch = patches[id];
    plant(meadow, patch);
    patch.touched = touched;
  }
  patches_ = std::move(patches);
  groups_.clear();
  chains_.clear();
}

}  // namespace prairie
