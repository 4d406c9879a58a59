// Fields of nodes: sparse, in an order of their own, bilinear.
#include "animation/node_field.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

namespace prairie {
namespace {

TEST(NodeFieldTest, NodesThatNothingTouchedCostNothing) {
  NodeField<float> field(0.25);
  EXPECT_EQ(field.at({123456, -98765}), 0.0f);
  EXPECT_TRUE(field.pages().empty());
  EXPECT_EQ(field.bytes(), 0u);
}

TEST(NodeFieldTest, MemoryFollowsTheAreaTouched) {
  NodeField<float> field(0.25);
  // A path of one node's width and 4000 nodes' length, far from everything.
  for (int n = 0; n < 4000; ++n) field.touch({n - 2000, 1000000}) = 1.0f;
  EXPECT_EQ(field.pages().size(), 250u);
  EXPECT_LT(field.bytes(), 251u * (256u * sizeof(float) + 64u));
  // A square of the same number of nodes.
  NodeField<float> square(0.25);
  for (int n = 0; n < 4096; ++n) square.touch({n % 64, n / 64}) = 1.0f;
  EXPECT_EQ(square.pages().size(), 16u);
}

TEST(NodeFieldTest, KeepsEveryNode) {
  NodeField<int> field(1.0);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> place(-300, 300);
  std::set<std::pair<int, int>> touched;
  for (int n = 0; n < 2000; ++n) {
    const NodeIndex node{place(random), place(random)};
    field.touch(node) = node.i * 1000 + node.j;
    touched.insert({node.i, node.j});
  }
  for (int j = -300; j <= 300; ++j) {
    for (int i = -300; i <= 300; ++i) {
      ASSERT_EQ(field.at({i, j}), touched.contains({i, j}) ? i * 1000 + j : 0) << i << ' ' << j;
    }
  }
}

TEST(NodeFieldTest, OrderDoesNotDependOnHistory) {
  NodeField<float> forward(1.0), backward(1.0);
  for (int n = -500; n <= 500; ++n) forward.touch({n, (n * 7) % 90}) = static_cast<float>(n);
  for (int n = 500; n >= -500; --n) backward.touch({n, (n * 7) % 90}) = static_cast<float>(n);
  EXPECT_TRUE(forward == backward);
  PageIndex previous{.j = -1000, .i = 0};
  for (const auto& [page, nodes] : forward.pages()) {
    EXPECT_TRUE(previous < page);
    previous = page;
  }
}

TEST(NodeFieldTest, FreesPagesAtRest) {
  NodeField<float> field(1.0);
  for (int n = 0; n < 10; ++n) field.touch({n * kPageNodes + 3, 5}) = static_cast<float>(n);
  field.free_pages([](float node) { return node < 4.5f; });
  EXPECT_EQ(field.pages().size(), 5u);
  EXPECT_EQ(field.at({3 * kPageNodes + 3, 5}), 0.0f);
  EXPECT_EQ(field.at({7 * kPageNodes + 3, 5}), 7.0f);
}

TEST(NodeFieldTest, VisitsThePagesOfARectangleInOrder) {
  NodeField<float> field(0.25);
  for (const PageIndex page :
       {PageIndex{.j = 1, .i = 2}, {.j = 0, .i = 3}, {.j = 1, .i = -1}, {.j = 0, .i = 9}, {.j = 2, .i = 1}})
    field.touch_page(page);
  std::vector<PageIndex> visited;
  field.for_pages({.j = 0, .i = 0}, {.j = 1, .i = 4},
                  [&](PageIndex page, const auto&) { visited.push_back(page); });
  EXPECT_EQ(visited, (std::vector<PageIndex>{{.j = 0, .i = 3}, {.j = 1, .i = 2}}));
}

}  // namespace
}  // namespace prairie
