#include "agents/slow_spells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace prairie {
namespace {

bool in_spell(const std::vector<SlowSpell>& spells, double u) {
  for (const SlowSpell& spell : spells) {
    if (u >= spell.from && u <= spell.to) return true;
  }
  return false;
}

TEST(SlowSpells, AreWhereTheSpeedIsBelowTheLimit) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int spells_seen = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    PieceVelocity v{{any(random), any(random)}, {any(random), any(random)}, {any(random), any(random)}};
    if (trial % 3 == 0) v.square = -v.linear + 0.1 * v.square;
    constexpr double kLimit = 0.4;
    const std::vector<SlowSpell> spells = slow_spells(v, kLimit);
    spells_seen += static_cast<int>(spells.size());
    double end = -1.0;
    for (const SlowSpell& spell : spells) {
      EXPECT_GE(spell.from, 0.0);
      EXPECT_LT(spell.from, spell.to);
      EXPECT_LE(spell.to, 1.0);
      EXPECT_GT(spell.from, end);
      end = spell.to;
      if (spell.from > 0.0) {
        EXPECT_NEAR(glm::length(v.at(spell.from)), kLimit, 1e-9);
      }
      if (spell.to < 1.0) {
        EXPECT_NEAR(glm::length(v.at(spell.to)), kLimit, 1e-9);
      }
    }
    for (double u = 0.0; u <= 1.0; u += 1.0 / 512.0) {
      const double speed = glm::length(v.at(u));
      if (std::abs(speed - kLimit) > 1e-9) {
        ASSERT_EQ(in_spell(spells, u), speed < kLimit) << trial << ' ' << u;
      }
    }
  }
  EXPECT_GT(spells_seen, 500);
}

TEST(SlowSpells, AShortHaltIsNotMissed) {
  // 1000 m/s to −1000 m/s: below 0.2 m/s for 2e-4 of the piece.
  const std::vector<SlowSpell> spells = slow_spells({{1000.0, 0.0}, {-2000.0, 0.0}, {}}, 0.2);
  ASSERT_EQ(spells.size(), 1u);
  EXPECT_NEAR(spells[0].from, 0.4999, 1e-9);
  EXPECT_NEAR(spells[0].to, 0.5001, 1e-9);
}

TEST(SlowSpells, StandingIsOneSpellAndWalkingNone) {
  const std::vector<SlowSpell> standing = slow_spells({}, 0.2);
  ASSERT_EQ(standing.size(), 1u);
  EXPECT_EQ(standing[0].from, 0.0);
  EXPECT_EQ(standing[0].to, 1.0);
  EXPECT_TRUE(slow_spells({{1.0, 0.0}, {}, {}}, 0.2).empty());
}

}  // namespace
}  // namespace prairie
