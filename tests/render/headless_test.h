// A test with an OpenGL 4.5 context and no window; where none can be made it is skipped, and says why. It
// fails if the driver complains of what it did.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "render/gl/context.h"
#include "render/gl/gl_debug.h"

namespace prairie {

class HeadlessTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  /// Mesa's software renderer, whose arithmetic is that of the CPU.
  static bool on_llvmpipe();
  /// For tests that cause messages on purpose.
  GlMessageLog& messages() { return *messages_; }

 private:
  std::optional<HeadlessContext> context_;
  std::optional<GlMessageLog> messages_;
};

}  // namespace prairie
