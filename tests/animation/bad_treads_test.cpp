// What treading refuses, and that a refusal changes nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "animation/treading.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_refused(Treading& treading, const std::function<void()>& action, const std::string& field) {
  const TreadState before = treading.state();
  try {
    action();
    FAIL() << field << " was accepted";
  } catch (const BadInput& fault) {
    EXPECT_NE(fault.field.find(field), std::string::npos) << fault.what();
    EXPECT_FALSE(fault.expected.empty());
  }
  EXPECT_TRUE(treading.state() == before);
}

TEST(BadTreadsTest, RefusesBadSteps) {
  Treading treading(TreadSettings{});
  const TreadStep good{.id = 1, .from_m = {0, 0}, .to_m = {0.02, 0}};
  treading.step({&good, 1}, 2.0);
  const auto refused = [&](auto change, const std::string& field) {
    TreadStep steps[2] = {good, good};
    steps[1].id = 7;
    change(steps[1]);
    expect_refused(
        treading, [&] { treading.step(steps, 2.1); }, field);
  };
  refused([](TreadStep& step) { step.radius_m = -0.1; }, "body 7: radius_m");
  refused([](TreadStep& step) { step.radius_m = 0.0; }, "body 7: radius_m");
  refused([](TreadStep& step) { step.radius_m = 1e6; }, "body 7: radius_m");
  refused([](TreadStep& step) { step.radius_m = kNan; }, "body 7: radius_m");
  refused([](TreadStep& step) { step.to_m.x = kNan; }, "body 7: position_m");
  refused([](TreadStep& step) { step.from_m.y = 1e30; }, "body 7: position_m");
  refused([](TreadStep& step) { step.to_m.y = 5000.0; }, "body 7: step_m");
  refused([](TreadStep& step) { step.weight = -1.0; }, "body 7: weight");
  refused([](TreadStep& step) { step.weight = std::numeric_limits<double>::infinity(); }, "body 7: weight");
  refused([](TreadStep& step) { step.id = 1; }, "body 1: id");
}

TEST(BadTreadsTest, TimeDoesNotGoBackwards) {
  Treading treading(TreadSettings{});
  treading.step({}, 2.0);
  expect_refused(
      treading, [&] { treading.step({}, 1.9); }, "time_s");
  expect_refused(
      treading, [&] { treading.step({}, kNan); }, "time_s");
  treading.step({}, 2.0);
}

TEST(BadTreadsTest, RefusesBadSettings) {
  const auto refused = [](auto change) {
    TreadSettings settings;
    change(settings);
    EXPECT_THROW(Treading{settings}, BadInput);
  };
  refused([](TreadSettings& settings) { settings.spacing_m = 0.0; });
  refused([](TreadSettings& settings) { settings.spacing_m = kNan; });
  refused([](TreadSettings& settings) { settings.field_scale = -1.0f; });
  refused([](TreadSettings& settings) { settings.recovery_s = -60.0; });
  refused([](TreadSettings& settings) { settings.worn_field = 1e9f; });
}

TEST(BadTreadsTest, RefusesBadStates) {
  Treading treading(TreadSettings{});
  const TreadStep step{.id = 1, .from_m = {0, 0}, .to_m = {0.5, 0}};
  treading.step({&step, 1}, 2.0);
  const auto refused = [&](auto change, const std::string& field) {
    TreadState state = treading.state();
    change(state);
    expect_refused(
        treading, [&] { treading.restore(state); }, field);
  };
  refused([](TreadState& state) { state.time_s = kNan; }, "time_s");
  refused([](TreadState& state) { state.nodes.touch({0, 0}).field = -1.0f; }, "field");
  refused([](TreadState& state) { state.nodes.touch({0, 0}).recovery_s = 0.0f; }, "recovery_s");
  refused([](TreadState& state) { state.nodes.touch({0, 0}).start_s = 3.0; }, "start_s");
  refused([](TreadState& state) { state.nodes.touch({0, 0}).direction.x = 1e9f; }, "direction");
  refused([](TreadState& state) { state.wear.touch({0, 0}) = 1.5f; }, "wear");
  refused([](TreadState& state) { state.nodes = NodeField<TreadNode>(0.25); }, "spacing_m");
  refused([](TreadState& state) { state.nodes.touch_page({1 << 30, 0}); }, "page");
}

TEST(BadTreadsTest, RefusesBadWear) {
  Treading treading(TreadSettings{});
  const float wear[2] = {0.5f, std::numeric_limits<float>::quiet_NaN()};
  expect_refused(
      treading,
      [&] {
        treading.write_wear({0, 0, 2, 1}, wear);
      },
      "wear");
}

}  // namespace
}  // namespace prairie
