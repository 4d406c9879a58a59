// Interaction patches in a planted meadow: what a stone rolls over.
#include "animation/touched_blades.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "generator/plant_cell.h"
#include "moving_meadow.h"

namespace prairie {
namespace {

using testing::moving_meadow;
using testing::moving_sway;
using testing::moving_traits;

constexpr double kStepS = 1.0 / 60.0;
constexpr double kRadiusM = 0.4;

/// A stone that rolls east through the middle of a meadow, treading.
struct Rolling {
  explicit Rolling(double wind_m_per_s, float density_per_m2 = 120.0f)
      : meadow(moving_meadow(density_per_m2)), traits(moving_traits()), treading(TreadSettings{}) {
    if (wind_m_per_s > 0.0) {
      wind.mean = MeanWind(glm::dvec2(wind_m_per_s, 0.5 * wind_m_per_s));
      sway.emplace(moving_sway(), glm::dvec2(12.0));
    }
  }

  glm::dvec3 centre_m() const { return {6.0 + 1.5 * std::min(time_s, 5.0), 12.0, kRadiusM}; }
  Surroundings around() const {
    return {meadow, traits, wind, treading, sway ? &*sway : nullptr, time_s, conditions};
  }

  void step() {
    const glm::dvec2 from(centre_m());
    time_s += kStepS;
    const TreadStep tread{0, from, glm::dvec2(centre_m()), 0.25, gone ? 0.0 : 1.5};
    treading.step({&tread, gone ? 0u : 1u}, time_s);
    if (sway) sway->step(wind, time_s, static_cast<float>(kStepS));
    const Solid stone = Sphere{centre_m(), kRadiusM};
    blades.step(around(), {&stone, gone ? 0u : 1u}, {12.0, 12.0}, static_cast<float>(kStepS));
  }

  Meadow meadow;
  std::vector<ChainTraits> traits;
  Wind wind;
  Treading treading;
  std::optional<Sway> sway;
  const ConditionWindow* conditions = nullptr;
  TouchedBlades blades;
  double time_s = 0.0;
  bool gone = false;
};

/// Every blade near a place as it is drawn: by itself or by the virtual model.
struct DrawnBlade {
  glm::dvec3 tile_base_m;
  Kernels::BladeChain chain;
  float length_m;
};

std::map<std::pair<CellId, std::uint32_t>, DrawnBlade> drawn_blades(const Rolling& rolling,
                                                                    glm::dvec2 around_m, double reach_m) {
  std::map<std::pair<CellId, std::uint32_t>, DrawnBlade> drawn;
  const PlantingLattice lattice(rolling.meadow);
  const double cell_m = rolling.meadow.tile_m / kCellsPerSide;
  const glm::ivec2 low(glm::floor((around_m - reach_m) / cell_m)),
      high(glm::floor((around_m + reach_m) / cell_m));
  for (int j = low.y; j <= high.y; ++j) {
    for (int i = low.x; i <= high.x; ++i) {
      const CellId id{{i >> 1, j >> 1}, (i & 1) + 2 * (j & 1)};
      CellTables tables;
      append_cell(rolling.meadow, lattice, id.tile, id.cell, tables);
      std::uint32_t index = 0;
      for (const PlantedCell& cell : tables.cells) {
        std::vector<Blade> blades(cell.planted);
        plant_cell(cell, rolling.meadow.species[cell.species].species.params, tables.tables, blades);
        const auto group = std::find_if(rolling.blades.groups().begin(), rolling.blades.groups().end(),
                                        [&](const TouchedGroup& one) { return one.key == cell.key; });
        std::vector<BladeOfCell> planted;
        for (const Blade& blade : blades) planted.push_back({&cell, &blade});
        std::vector<StandingBlade> standing(planted.size());
        find_standing(rolling.around(), id.tile, tables, planted, standing);
        for (std::uint32_t k = 0; k < cell.planted; ++k, ++index) {
          const StandingBlade& now = standing[k];
          const std::uint32_t slot = group == rolling.blades.groups().end() ? 0 : group->slots[k];
          drawn[{id, index}] = {
              glm::dvec3(tile_origin_m(rolling.meadow, id.tile), tile_base_m(rolling.meadow, id.tile)),
              slot != 0 ? rolling.blades.chains()[slot - 1] : now.chain(now.virtual_turn, now.least_rise),
              now.blade.height_m};
        }
      }
    }
  }
  return drawn;
}

TEST(TouchedBlades, NoDrawnBladeIsInsideTheStone) {
  for (const double wind_m_per_s : {0.0, 5.0}) {
    Rolling rolling(wind_m_per_s);
    double deepest_m = 0.0, highest_m = 0.0;
    std::size_t under = 0, beside = 0;
    for (int step = 0; step < 240; ++step) {
      rolling.step();
      if (step % 12 != 11) continue;
      const Solid stone = Sphere{rolling.centre_m(), kRadiusM};
      for (const auto& [id, blade] : drawn_blades(rolling, glm::dvec2(rolling.centre_m()), 1.5)) {
        const glm::dvec3 root_m = blade.tile_base_m + glm::dvec3(blade.chain.p0);
        const bool is_under = separation(stone, root_m).distance_m < 2e-3;
        ++(is_under ? under : beside);
        for (int n = 0; n <= 60; ++n) {
          const glm::dvec3 point_m = blade.tile_base_m + glm::dvec3(Kernels{}.chain_point(
                                                             blade.chain, static_cast<float>(n) / 60.0f));
          if (is_under) {
            highest_m = std::max(highest_m, point_m.z - root_m.z);
          } else {
            deepest_m = std::max(deepest_m, -separation(stone, point_m).distance_m);
          }
        }
      }
    }
    std::printf("wind %.0f m/s: %zu beside, at most %.2f mm inside; %zu under, at most %.2f mm high\n",
                wind_m_per_s, beside, 1e3 * deepest_m, under, 1e3 * highest_m);
    EXPECT_LE(deepest_m, 1e-3);
    EXPECT_LE(highest_m, 5e-3);
    EXPECT_GT(beside, 10000u);
  }
}

TEST(TouchedBlades, ComeBackWithoutAJump) {
  Rolling rolling(0.0);
  for (int step = 0; step < 90; ++step) rolling.step();
  rolling.gone = true;
  EXPECT_GT(rolling.blades.size(), 10u);
  auto before = drawn_blades(rolling, {7.5, 12.0}, 2.5);
  std::map<std::pair<CellId, std::uint32_t>, bool> faded;
  float most = 0.0f;
  for (int step = 0; step < 600; ++step) {
    std::map<std::pair<CellId, std::uint32_t>, bool> fading;
    for (const auto& [id, touched] : rolling.blades.state()) {
      for (const TouchedBlade& blade : touched) fading[{id, blade.index}] = blade.fades != 0;
    }
    rolling.step();
    const auto now = drawn_blades(rolling, {7.5, 12.0}, 2.5);
    for (const auto& [blade, is_fading] : fading) {
      if (!is_fading || !now.contains(blade)) continue;
      most = std::max(
          most, glm::distance(now.at(blade).chain.p4, before.at(blade).chain.p4) / now.at(blade).length_m);
    }
    before = now;
    if (rolling.blades.size() == 0) break;
  }
  std::printf("tips move by at most %.2f %% of the length in a step while they fade\n",
              100.0 * static_cast<double>(most));
  EXPECT_EQ(rolling.blades.size(), 0u) << "left behind";
  EXPECT_LE(most, 0.0101f);
}

TEST(TouchedBlades, KeepOnlyWhatIsTouched) {
  Rolling rolling(0.0);
  std::size_t most = 0;
  for (int step = 0; step < 240; ++step) {
    rolling.step();
    most = std::max(most, rolling.blades.size());
  }
  // A disc of two radii and the wake of one second.
  EXPECT_LT(most, 1200u);
  EXPECT_GT(most, 30u);
}

TEST(TouchedBlades, AreTheSameForAnyNumberOfThreadsAndAfterARestore) {
  const auto run = [](std::size_t threads, bool restored) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Rolling rolling(4.0);
    for (int step = 0; step < 90; ++step) {
      rolling.step();
      if (!restored || step != 40) continue;
      const TouchedState state = rolling.blades.state();
      rolling.blades = TouchedBlades();
      rolling.blades.restore(state, rolling.meadow);
      rolling.blades.pose(rolling.around());
    }
    return rolling.blades.state();
  };
  const TouchedState one = run(1, false);
  EXPECT_FALSE(one.empty());
  EXPECT_TRUE(one == run(4, false));
  EXPECT_TRUE(one == run(2, true));
}

// In calm air, where blades do not sway at a frequency of their own.
TEST(TouchedBlades, SwingInFrostAsAStifferSpecies) {
  ConditionWindow frost({12.0, 12.0});
  const Condition everywhere{.centre_m = {12.0, 12.0}, .radius_m = 1e5, .stiffness_factor = 4.0};
  frost.show({&everywhere, 1}, {12.0, 12.0}, 0.0);
  Rolling frozen(0.0), bred(0.0), plain(0.0);
  frozen.conditions = &frost;
  for (PlantedSpecies& planted : bred.meadow.species) planted.species.params.stiffness *= 4.0f;
  for (ChainTraits& traits : bred.traits) traits.stiffness *= 4.0f;
  float most = 0.0f, plain_most = 0.0f;
  for (int step = 0; step < 240; ++step) {
    for (Rolling* rolling : {&frozen, &bred, &plain}) rolling->step();
    ASSERT_EQ(frozen.blades.size(), bred.blades.size());
    const TouchedState a = frozen.blades.state(), b = bred.blades.state();
    for (std::size_t cell = 0; cell < a.size(); ++cell) {
      for (std::size_t n = 0; n < a[cell].second.size(); ++n)
        most =
            std::max(most, glm::length(a[cell].second[n].motion.turn.v4 - b[cell].second[n].motion.turn.v4));
    }
    const TouchedState c = plain.blades.state();
    for (std::size_t n = 0; !a.empty() && !c.empty() && n < std::min(a[0].second.size(), c[0].second.size());
         ++n)
      plain_most =
          std::max(plain_most, glm::length(a[0].second[n].motion.turn.v4 - c[0].second[n].motion.turn.v4));
  }
  EXPECT_GE(frozen.blades.size(), 20u);
  EXPECT_LT(most, 1e-4f) << "rad";
  EXPECT_GT(plain_most, 0.05f) << "rad, of blades that are not frozen";
}

}  // namespace
}  // namespace prairie
