// The same treads for any number of threads, any order of bodies, and in one run or two.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>

#include "animation/treading.h"
#include "tests/animation/random_walkers.h"

namespace prairie {
namespace {

constexpr double kDtS = 1.0 / 60.0;

void run(Treading& treading, int first, int end, bool reversed = false) {
  const RandomWalkers walkers(300, 20.0, kDtS);
  for (int step = first; step < end; ++step) {
    std::vector<TreadStep> steps = walkers.steps(step);
    if (reversed) std::reverse(steps.begin(), steps.end());
    treading.step(steps, (step + 1) * kDtS);
  }
}

TreadState state_with_threads(std::size_t threads) {
  oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  Treading treading(TreadSettings{});
  run(treading, 0, 240);
  return treading.state();
}

TEST(TreadingDeterminismTest, AnyNumberOfThreads) {
  const TreadState one = state_with_threads(1);
  EXPECT_TRUE(one == state_with_threads(2));
  EXPECT_TRUE(one == state_with_threads(7));
}

TEST(TreadingDeterminismTest, AnyOrderOfBodies) {
  Treading forward(TreadSettings{}), backward(TreadSettings{});
  run(forward, 0, 120);
  run(backward, 0, 120, true);
  EXPECT_TRUE(forward.state() == backward.state());
}

TEST(TreadingDeterminismTest, SplitRunsEqualOne) {
  Treading whole(TreadSettings{}), first(TreadSettings{}), second(TreadSettings{});
  run(whole, 0, 240);
  run(first, 0, 101);
  second.restore(first.state());
  run(second, 101, 240);
  EXPECT_TRUE(whole.state() == second.state());
}

TEST(TreadingDeterminismTest, RestoresPageByPage) {
  Treading treading(TreadSettings{});
  run(treading, 0, 60);
  // As a reader of saved state would.
  TreadState copy{treading.state().time_s, NodeField<TreadNode>(treading.settings().spacing_m),
                  NodeField<float>(treading.settings().spacing_m)};
  for (const auto& [page, nodes] : treading.state().nodes.pages()) copy.nodes.touch_page(page) = nodes;
  for (const auto& [page, wear] : treading.state().wear.pages()) copy.wear.touch_page(page) = wear;
  Treading other(TreadSettings{});
  other.restore(copy);
  EXPECT_TRUE(other.state() == treading.state());
}

}  // namespace
}  // namespace prairie
