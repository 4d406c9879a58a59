// What comes over grass: masks, averages, and blocks of nodes.
#include "animation/condition.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "files/error.h"

namespace prairie {
namespace {

Condition frost(glm::dvec2 centre_m) {
  return {.centre_m = centre_m, .color_factor = {1.35f, 1.4f, 1.6f}, .stiffness_factor = 4.0};
}

Condition drought(glm::dvec2 centre_m) {
  return {.centre_m = centre_m, .color_factor = {1.5f, 1.15f, 0.6f}, .stiffness_factor = 0.5};
}

GrassCondition grass_at(const std::vector<Condition>& conditions, glm::dvec2 place_m, double time_s = 1.0) {
  return grass_condition(present_conditions(conditions, time_s), place_m);
}

/// The formula as it is written, in double.
struct Expected {
  glm::dvec3 color;
  double stiffness;
};
Expected expected(const std::vector<Condition>& conditions, const std::vector<double>& weights) {
  double sum = 0.0, log_stiffness = 0.0;
  glm::dvec3 color(0.0);
  for (std::size_t n = 0; n < conditions.size(); ++n) {
    sum += weights[n];
    color += weights[n] * glm::dvec3(conditions[n].color_factor);
    log_stiffness += weights[n] * std::log(conditions[n].stiffness_factor);
  }
  const double most = std::max(1.0, sum);
  return {(glm::dvec3(std::max(1.0 - sum, 0.0)) + color) / most, std::exp(log_stiffness / most)};
}

void expect_near(const GrassCondition& found, const Expected& wanted, const char* what) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(static_cast<double>(found.color_factor[c]), wanted.color[c], 1e-6) << what;
  EXPECT_NEAR(static_cast<double>(found.stiffness_factor) / wanted.stiffness, 1.0, 1e-6) << what;
}

// With a mask that rises from 0 to 1 over 3 m: t²(3 − 2t).
double mask(double inside_m) {
  const double t = std::clamp(inside_m / 3.0, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

TEST(ConditionTest, OneIsItsFactorsInsideAndNothingOutside) {
  const std::vector<Condition> one{frost({5.0, 2.0})};
  const GrassCondition inside = grass_at(one, {8.0, 1.0});
  EXPECT_EQ(inside.color_factor, glm::vec3(1.35f, 1.4f, 1.6f));
  EXPECT_NEAR(inside.stiffness_factor, 4.0f, 2e-6f);
  EXPECT_EQ(grass_at(one, {15.0, 2.0}), GrassCondition{}) << "at the border";
  EXPECT_EQ(grass_at(one, {40.0, 2.0}), GrassCondition{});
  EXPECT_EQ(grass_at({}, {0.0, 0.0}), GrassCondition{});
}

TEST(ConditionTest, FadesSmoothlyToItsBorder) {
  const auto present = present_condition(frost({0.0, 0.0}), 1.0).value();
  EXPECT_EQ(weight_at(present, {7.0, 0.0}), 1.0f);
  EXPECT_EQ(weight_at(present, {0.0, 10.0}), 0.0f);
  double last = 0.0, steepest = 0.0;
  constexpr double kStepM = 1e-3;
  for (double inside_m = 0.0; inside_m <= 3.0; inside_m += kStepM) {
    const auto weight = static_cast<double>(weight_at(present, {inside_m - 10.0, 0.0}));
    EXPECT_NEAR(weight, mask(inside_m), 1e-6);
    EXPECT_GE(weight, last - 1e-6);
    EXPECT_TRUE(inside_m > 0.01 || weight < 1e-4) << "no slope at the border";
    steepest = std::max(steepest, (weight - last) / kStepM);
    last = weight;
  }
  EXPECT_NEAR(steepest, 0.5, 1e-2);  // 1.5 over the edge
}

TEST(ConditionTest, OverlappingOnesAreAveraged) {
  const std::vector<Condition> two{frost({0.0, 0.0}), drought({8.0, 0.0})};
  struct Case {
    const char* what;
    glm::dvec2 place_m;
  };
  for (const auto& [what, place_m] : {Case{"both in full", {4.0, 0.0}}, Case{"one at its edge", {-1.0, 0.0}},
                                      Case{"both at their edges", {4.0, 8.2}}, Case{"one alone", {-4.0, 3.0}},
                                      Case{"together less than 1", {4.0, 9.0}}}) {
    const std::vector<double> weights{mask(10.0 - std::hypot(place_m.x, place_m.y)),
                                      mask(10.0 - std::hypot(place_m.x - 8.0, place_m.y))};
    expect_near(grass_at(two, place_m), expected(two, weights), what);
  }
  const GrassCondition both = grass_at(two, {4.0, 0.0});
  EXPECT_NEAR(both.color_factor.x, 1.425f, 1e-6f);
  EXPECT_NEAR(both.stiffness_factor, std::sqrt(2.0f), 1e-6f) << "4 and 1/2";
}

TEST(ConditionTest, TheirOrderMakesNoDifference) {
  const std::vector<Condition> all{frost({0.0, 0.0}), drought({8.0, 0.0}), frost({3.0, 5.0}),
                                   drought({-2.0, -3.0})};
  std::vector<Condition> backwards(all.rbegin(), all.rend());
  for (double x = -15.0; x < 20.0; x += 0.7) {
    const GrassCondition a = grass_at(all, {x, 1.5}), b = grass_at(backwards, {x, 1.5});
    EXPECT_LT(glm::length(a.color_factor - b.color_factor), 5e-7f);
    EXPECT_NEAR(a.stiffness_factor / b.stiffness_factor, 1.0f, 1e-6f);
  }
}

TEST(ConditionTest, ComesTravelsAndGoes) {
  Condition spell = frost({10.0, 0.0});
  spell.velocity_m_per_s = {2.0, -1.0};
  spell.start_s = 5.0;
  spell.duration_s = 40.0;
  spell.fade_s = 10.0;
  EXPECT_FALSE(present_condition(spell, 4.9));
  EXPECT_FALSE(present_condition(spell, 5.0));
  EXPECT_NEAR(present_condition(spell, 10.0)->strength, 0.5f, 1e-6f);
  EXPECT_EQ(present_condition(spell, 20.0)->strength, 1.0f);
  EXPECT_EQ(present_condition(spell, 20.0)->centre_m, glm::dvec2(40.0, -15.0));
  EXPECT_NEAR(present_condition(spell, 40.0)->strength, 0.5f, 1e-6f);
  EXPECT_FALSE(present_condition(spell, 45.0));
  EXPECT_EQ(end_s(spell), 45.0);

  spell.duration_s = 10.0;  // too short to come in full for longer than a moment
  EXPECT_NEAR(present_condition(spell, 10.0)->strength, 1.0f, 1e-6f);
  spell.duration_s = 0.0;
  EXPECT_EQ(present_condition(spell, 1e6)->strength, 1.0f);
  EXPECT_EQ(end_s(spell), std::numeric_limits<double>::infinity());
  spell.fade_s = 0.0;
  EXPECT_EQ(present_condition(spell, 5.0)->strength, 1.0f) << "at once";
}

TEST(ConditionTest, NodesHoldWhatPlacesHave) {
  const std::vector<PresentCondition> present =
      present_conditions(std::vector<Condition>{frost({0.0, 0.0}), drought({8.0, 3.0})}, 1.0);
  const NodeBlock nodes{{-40, -30}, 101, 77, 0.5};
  std::vector<GrassCondition> values(nodes.size());
  fill_conditions(present, nodes, values);
  for (int row = 0; row < nodes.rows; ++row) {
    for (int column = 0; column < nodes.columns; ++column) {
      const glm::dvec2 place_m(0.5 * (column - 40), 0.5 * (row - 30));
      ASSERT_EQ(values[static_cast<std::size_t>(row * nodes.columns + column)],
                grass_condition(present, place_m))
          << place_m.x << ' ' << place_m.y;
    }
  }
}

TEST(ConditionTest, CostsNothingWhereItDoesNotReach) {
  const NodeBlock nodes{{-64, -64}, 129, 129, 1.0};
  std::vector<GrassCondition> values(nodes.size());
  const auto visited = [&](const std::vector<Condition>& conditions) {
    return fill_conditions(present_conditions(conditions, 1.0), nodes, values);
  };
  EXPECT_EQ(visited({}), 0u);
  EXPECT_EQ(visited({frost({500.0, 0.0})}), 0u);
  EXPECT_EQ(visited({frost({0.5, 0.5})}), 20u * 20u) << "its box, of 129²";
  EXPECT_EQ(visited({frost({0.5, 0.5}), drought({0.5, 500.0}), drought({64.5, 0.5})}), 20u * 20u + 10u * 20u);
  std::size_t changed = 0;
  for (const GrassCondition& value : values) changed += value == GrassCondition{} ? 0 : 1;
  EXPECT_LT(changed, 600u);
}

TEST(ConditionTest, AnyNumberOfThreads) {
  const std::vector<PresentCondition> present =
      present_conditions(std::vector<Condition>{frost({0.0, 0.0}), drought({8.0, 3.0})}, 1.0);
  const auto filled = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<GrassCondition> values(129 * 129);
    fill_conditions(present, {{-64, -64}, 129, 129, 0.5}, values);
    return values;
  };
  EXPECT_EQ(filled(1), filled(2));
  EXPECT_EQ(filled(1), filled(5));
}

TEST(ConditionTest, RefusesNumbersOutOfRange) {
  EXPECT_NO_THROW(check(frost({0.0, 0.0}), "frost"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    Condition condition = frost({0.0, 0.0});
    change(condition);
    try {
      check(condition, "frost");
    } catch (const BadInput& fault) {
      return fault.field;
    }
    return std::string();
  };
  EXPECT_EQ(refused([&](Condition& c) { c.centre_m.y = nan; }), "frost: centre_m");
  EXPECT_EQ(refused([](Condition& c) { c.velocity_m_per_s.x = 101.0; }), "frost: velocity_m_per_s");
  EXPECT_EQ(refused([](Condition& c) { c.radius_m = -1.0; }), "frost: radius_m");
  EXPECT_EQ(refused([&](Condition& c) { c.radius_m = nan; }), "frost: radius_m");
  EXPECT_EQ(refused([](Condition& c) { c.edge_m = 10.5; }), "frost: edge_m") << "more than the radius";
  EXPECT_EQ(refused([](Condition& c) { c.edge_m = 0.0; }), "frost: edge_m");
  EXPECT_EQ(refused([](Condition& c) { c.start_s = 1e10; }), "frost: start_s");
  EXPECT_EQ(refused([](Condition& c) { c.duration_s = -1.0; }), "frost: duration_s");
  EXPECT_EQ(refused([&](Condition& c) { c.fade_s = nan; }), "frost: fade_s");
  EXPECT_EQ(refused([](Condition& c) { c.color_factor.z = 4.5f; }), "frost: color_factor");
  EXPECT_EQ(refused([](Condition& c) { c.color_factor.x = -0.1f; }), "frost: color_factor");
  EXPECT_EQ(refused([](Condition& c) { c.stiffness_factor = 0.05; }), "frost: stiffness_factor");
  EXPECT_EQ(refused([](Condition& c) { c.stiffness_factor = 11.0; }), "frost: stiffness_factor");
}

}  // namespace
}  // namespace prairie
