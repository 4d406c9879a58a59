// A state that is saved and loaded goes on as if nothing had happened; anything else is refused, in words,
// and changes nothing.
#include "world/state_file.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <ostream>

#include "files/little_endian.h"
#include "tests/world/scene_texts.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

using Bytes = std::vector<std::byte>;

constexpr const char* kMeadow = R"(version = 1
[ground]
size_m = [24, 16]
[[species]]
name = "fescue"
density = 40.0
[[species]]
name = "oat"
density = 10.0
[[mover]]
name = "stone"
path_m = [[4, 8], [20, 9]]
[[mover]]
name = "cart"
kind = "cart"
speed_m_per_s = 2.0
path_m = [[20, 4], [4, 5]]
)";
constexpr const char* kWind = R"([wind]
speed_m_per_s = 6
heading_deg = 80
[[wind.gust]]
position_m = [-10, 8]
strength_m_per_s = 8
)";
constexpr double kStepS = 1.0 / 60.0;
constexpr glm::dvec2 kEyeM{9.0, 6.0};

World windy() {
  return World(parse_scene(std::string(kMeadow) + kWind, "folder", {}), {});
}

/// Small in bytes: no texture of the wind.
World calm() {
  return World(parse_scene(kMeadow, "folder", {}), {});
}

void run(World& world, int steps) {
  for (int n = 0; n < steps; ++n) world.step(kStepS);
}

/// After a second, with an eye that has gone some way, touched blades and treads.
const Bytes& calm_state() {
  static const Bytes bytes = [] {
    World world = calm();
    world.motion().watch(kEyeM);
    run(world, 60);
    return world.saved_state();
  }();
  return bytes;
}

/// "nothing" where the bytes are taken.
std::string refusal(World& world, const Bytes& bytes) {
  const Bytes before = world.saved_state();
  try {
    world.load_state(bytes, "a.state");
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, "a.state");
    EXPECT_FALSE(fault.expected.empty());
    EXPECT_EQ(std::string_view(fault.what()).find('\n'), std::string_view::npos);
    EXPECT_EQ(world.saved_state(), before) << fault.what();
    return fault.what();
  }
  return "nothing";
}

struct Case {
  bool is_windy;
  bool is_watched;
  std::size_t threads;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << (one.is_windy ? "windy" : "calm") << (one.is_watched ? ", watched, " : ", unwatched, ")
       << one.threads;
}

class StateFile : public ::testing::TestWithParam<Case> {};

TEST_P(StateFile, GoesOnBitForBit) {
  const Case& one = GetParam();
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, one.threads);
  const auto fresh = [&] { return one.is_windy ? windy() : calm(); };
  // An eye that walks, so that windows move and patches come and go.
  const auto go = [&](World& world, int first, int end) {
    for (int n = first; n < end; ++n) {
      if (one.is_watched) world.motion().watch(kEyeM + glm::dvec2(0.03 * n, 0.0));
      world.step(kStepS);
    }
  };
  World whole = fresh(), first = fresh(), second = fresh();
  go(whole, 0, 180);
  go(first, 0, 90);
  const Bytes between = first.saved_state();
  second.load_state(between, "");
  EXPECT_EQ(second.saved_state(), between);
  EXPECT_EQ(second.motion().ticks(), first.motion().ticks());
  go(second, 90, 180);
  EXPECT_EQ(second.saved_state(), whole.saved_state());
  // Shapes that are drawn.
  EXPECT_EQ(second.motion().touched().size(), whole.motion().touched().size());
  EXPECT_GE(whole.motion().touched().size(), one.is_watched ? 20u : 0u);
  EXPECT_EQ(whole.motion().sway().has_value(), one.is_watched && one.is_windy);
  if (whole.motion().sway()) {
    const auto a = whole.motion().sway()->image(), b = second.motion().sway()->image();
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, StateFile,
                         ::testing::Values(Case{true, true, 1}, Case{true, true, 2}, Case{true, false, 2},
                                           Case{false, true, 2}, Case{false, false, 1}));

TEST(StateFileTest, IsTheSameForAnyNumberOfThreads) {
  const auto with_threads = [](std::size_t threads) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    World world = windy();
    world.motion().watch(kEyeM);
    run(world, 45);
    return world.saved_state();
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(StateFileTest, LoadsOverAWorldThatHasGoneOn) {
  World world = windy();
  const Bytes start = world.saved_state();
  world.motion().watch(kEyeM);
  run(world, 30);
  world.load_state(start, "");
  EXPECT_EQ(world.saved_state(), start);
  EXPECT_EQ(world.time_s(), 0.0);
  EXPECT_FALSE(world.motion().sway());
}

TEST(StateFileTest, CutShortAnywhere) {
  World world = calm();
  const Bytes& whole = calm_state();
  ASSERT_GT(whole.size(), 10'000u);
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    const std::string said =
        refusal(world, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
    ASSERT_NE(said.find(length == 0 ? "no state" : "cut short"), std::string::npos) << length << ": " << said;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_NE(refusal(world, longer).find("ends after"), std::string::npos);
}

TEST(StateFileTest, CutShortAndSealed) {
  World world = calm();
  const Bytes& whole = calm_state();
  for (std::size_t length = kStateHeaderBytes; length < whole.size(); length += 97) {
    Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    seal_state(bytes);
    ASSERT_NE(refusal(world, bytes), "nothing") << length;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  seal_state(longer);
  EXPECT_NE(refusal(world, longer).find("the end of the file"), std::string::npos);
}

TEST(StateFileTest, FlippedBits) {
  World world = calm();
  Bytes bytes = calm_state();
  for (std::size_t at = 0; at < bytes.size(); at += at < 300 ? 1 : 89) {
    const std::byte kept = bytes[at];
    bytes[at] ^= std::byte{static_cast<unsigned char>(1u << at % 8)};
    const std::string said = refusal(world, bytes);
    ASSERT_NE(said, "nothing") << at;
    ASSERT_NE(said.find(at < 20 ? "expected" : "damaged"), std::string::npos) << at << ": " << said;
    bytes[at] = kept;
  }
}

/// Flips that the checksum does not tell: taken over or refused, never half taken over.
TEST(StateFileTest, FlippedBitsUnderAGoodChecksum) {
  World world = calm();
  Bytes bytes = calm_state();
  int taken = 0, refused = 0;
  for (std::size_t at = kStateHeaderBytes; at < bytes.size(); at += at < 300 ? 1 : 89) {
    const std::byte kept = bytes[at];
    bytes[at] ^= std::byte{static_cast<unsigned char>(1u << at % 8)};
    seal_state(bytes);
    if (refusal(world, bytes) == "nothing") {
      ++taken;
      EXPECT_EQ(world.saved_state(), bytes);
    } else {
      ++refused;
    }
    bytes[at] = kept;
  }
  std::printf("%d taken, %d refused\n", taken, refused);
  EXPECT_GT(refused, 60);
  EXPECT_NO_THROW(world.step(kStepS));
}

TEST(StateFileTest, SaysWhatIsWrong) {
  World world = calm();
  const auto says = [&](Bytes bytes, const char* words) {
    const std::string said = refusal(world, bytes);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  const std::string text = "version = 1\n";
  Bytes scene(text.size());
  std::transform(text.begin(), text.end(), scene.begin(), [](char c) { return std::byte(c); });
  says(scene, "found no state, expected a file that --save-state wrote");

  Bytes newer = calm_state();
  put_little_endian(std::span(newer).subspan(8, 4), std::uint32_t{3});
  seal_state(newer);
  says(newer, "version 3, of a newer program");

  World other(parse_scene(kMeadow, "folder", {"mover.stone.radius_m=0.3"}), {});
  other.step(kStepS);
  says(other.saved_state(), "a state of another scene");
  World seeded(parse_scene(kMeadow, "folder", {"seed=9"}), {});
  says(seeded.saved_state(), "settings or seed");
}

/// Of numbers that a file may hold and that a state may not.
class StateNumbers : public ::testing::Test {
 protected:
  StateNumbers() : world_(calm()) {
    world_.motion().watch(kEyeM);
    run(world_, 60);
  }

  void expect_refused(const std::function<void(MotionState&)>& change, const char* field,
                      const char* words = "") {
    MotionState state = world_.motion().state();
    change(state);
    const std::string said =
        refusal(world_, state_bytes({state, {}}, {world_.motion_hash(), world_.scene().treading}));
    EXPECT_NE(said.find(std::string(": ") + field), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }

  World world_;
};

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_F(StateNumbers, Time) {
  expect_refused([](MotionState& state) { state.ticks = -1; }, "time");
  expect_refused([](MotionState& state) { state.ticks = std::numeric_limits<std::int64_t>::max(); }, "time");
  expect_refused([](MotionState& state) { state.ticks = 0; }, "treads.start_s");
}

TEST_F(StateNumbers, Treads) {
  const auto node = [](MotionState& state) -> TreadNode& { return state.treading.nodes.touch({70, 64}); };
  expect_refused([&](MotionState& state) { node(state).field = kNan; }, "trodden", "finite");
  expect_refused([&](MotionState& state) { node(state).start_s = kInfinity; }, "trodden", "finite");
  expect_refused([&](MotionState& state) { node(state).field = -1.0f; }, "treads.field");
  expect_refused([&](MotionState& state) { node(state).direction.x = 9.0f; }, "treads.direction");
  expect_refused([&](MotionState& state) { state.treading.wear.touch({70, 64}) = 1.5f; }, "wear");
  expect_refused([&](MotionState& state) { state.treading.nodes.touch_page({1 << 30, 0}); }, "treads.page");
  expect_refused([&](MotionState& state) { state.treading.wear.touch_page({0, -(1 << 30)}); }, "treads.page");
}

TEST_F(StateNumbers, SettingsOfTreading) {
  TreadSettings settings = world_.scene().treading;
  settings.recovery_s += 1.0;
  const std::string said =
      refusal(world_, state_bytes({world_.motion().state(), {}}, {world_.motion_hash(), settings}));
  EXPECT_NE(said.find("treading: found recovery_s"), std::string::npos) << said;
}

TEST_F(StateNumbers, Eye) {
  expect_refused([](MotionState& state) { state.eye_m = glm::dvec2(0.0, kInfinity); }, "eye", "finite");
  expect_refused([](MotionState& state) { state.eye_m = glm::dvec2(0.0, 1e9); }, "eye_m");
  expect_refused([](MotionState& state) { state.eye_m.reset(); }, "eye_m", "without an eye");
}

TEST_F(StateNumbers, Sway) {
  expect_refused(
      [](MotionState& state) {
        state.sway = SwayState{*state.eye_m, std::vector<ChainMotion>(7)};
      },
      "sway", "7 blades");
  expect_refused([](MotionState& state) { state.sway = SwayState{*state.eye_m, {}}; }, "sway", "0 blades");
  World windy_world = windy();
  windy_world.motion().watch(kEyeM);
  windy_world.step(kStepS);
  MotionState state = windy_world.motion().state();
  const StateOwner owner{windy_world.motion_hash(), windy_world.scene().treading};
  for (const float wrong : {9.0f, -9.0f}) {
    state.sway.value().motions[5000].turn.v3.y = wrong;
    EXPECT_NE(refusal(windy_world, state_bytes({state, {}}, owner)).find("sway.turn"), std::string::npos);
  }
  state.sway.value().motions[5000].turn.v3.y = kNan;
  EXPECT_NE(refusal(windy_world, state_bytes({state, {}}, owner)).find("finite"), std::string::npos);
}

TEST_F(StateNumbers, TouchedBlades) {
  ASSERT_GT(world_.motion().touched().size(), 20u);
  const auto blade = [](MotionState& state) -> TouchedBlade& { return state.touched.front().second.front(); };
  expect_refused([&](MotionState& state) { blade(state).motion.rate.v4.z = kNan; }, "touched", "finite");
  expect_refused([&](MotionState& state) { blade(state).motion.rate.v4.z = 1e9f; }, "touched.rate");
  expect_refused([&](MotionState& state) { blade(state).motion.turn.v1.x = 4.0f; }, "touched.turn");
  expect_refused([&](MotionState& state) { blade(state).rest.v1.x = 2.0f; }, "touched.rest");
  expect_refused([&](MotionState& state) { blade(state).offset.v1.x = 7.0f; }, "touched.offset");
  expect_refused([&](MotionState& state) { blade(state).rise = -2.0f; }, "touched.rise");
  expect_refused([&](MotionState& state) { blade(state).near_steps = -1; }, "touched.near_steps");
  expect_refused([&](MotionState& state) { blade(state).fades = 2; }, "touched.fades");
  const auto last = [](MotionState& state) -> TouchedBlade& { return state.touched.back().second.back(); };
  // Nothing is planted beyond the cell's count.
  expect_refused([&](MotionState& state) { last(state).index = 5000; }, "touched.index", "one of the");
  expect_refused([&](MotionState& state) { last(state).index = 1u << 24; }, "touched.index",
                 "less than 16777216");
  expect_refused(
      [](MotionState& state) {
        state.touched.front().second.push_back(state.touched.front().second.front());
      },
      "touched.index", "once");
  expect_refused([](MotionState& state) { state.touched.push_back(state.touched.front()); }, "touched.cell",
                 "order");
  expect_refused([](MotionState& state) { state.touched.back().first.cell = 4; }, "touched.cell", "0 to 3");
  expect_refused([](MotionState& state) { state.touched.back().first.tile.i = 1000; }, "touched.cell",
                 "meadow");
  expect_refused([](MotionState& state) { state.touched.back().second.clear(); }, "touched.cell",
                 "at least one");
}

}  // namespace
}  // namespace prairie
