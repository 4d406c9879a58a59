// A lost context is told as such; one that is well is not.
#include "render/gl/graphics_reset.h"

#include <chrono>
#include <string>

#include "files/error.h"
#include "tests/render/headless_test.h"

namespace prairie {
namespace {

template <GraphicsReset kReset>
GraphicsReset always() {
  return kReset;
}

std::string message_of(GraphicsReset (*ask)()) {
  try {
    check_context(ask);
  } catch (const LostContext& lost) {
    return lost.what();
  }
  return "";
}

TEST(GraphicsResetTest, IsTypedAndSaysWhoseFaultItWas) {
  EXPECT_EQ(message_of(always<GraphicsReset::kNone>), "");
  const std::string guilty = message_of(always<GraphicsReset::kGuilty>);
  EXPECT_NE(guilty.find("which this drawing caused"), std::string::npos) << guilty;
  EXPECT_NE(guilty.find("--size"), std::string::npos) << "what to try: " << guilty;
  const std::string innocent = message_of(always<GraphicsReset::kInnocent>);
  EXPECT_NE(innocent.find("another program"), std::string::npos) << innocent;
  EXPECT_NE(message_of(always<GraphicsReset::kUnknown>), "");
  // The exit code follows from this.
  EXPECT_THROW(check_context(always<GraphicsReset::kUnknown>), NoSuitableOpenGl);
}

TEST(GraphicsResetTest, IsNotAwaitedForEver) {
  const auto start = std::chrono::steady_clock::now();
  await_end_of_reset(always<GraphicsReset::kNone>);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  static int left = 3;
  await_end_of_reset([] { return left-- > 0 ? GraphicsReset::kInnocent : GraphicsReset::kNone; });
  EXPECT_EQ(left, -1);
  await_end_of_reset(always<GraphicsReset::kGuilty>);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

using LiveContextTest = HeadlessTest;

TEST_F(LiveContextTest, IsNotLost) {
  EXPECT_EQ(graphics_reset(), GraphicsReset::kNone);
  EXPECT_NO_THROW(check_context());
}

TEST_F(LiveContextTest, WouldTellOnMesa) {
  if (!on_llvmpipe()) GTEST_SKIP() << "other drivers need not tell of resets";
  GLint strategy = 0;
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
  EXPECT_EQ(strategy, GL_LOSE_CONTEXT_ON_RESET);
}

}  // namespace
}  // namespace prairie
