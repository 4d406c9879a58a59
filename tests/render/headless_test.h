// A test with an OpenGL 4.5 context and no window; where none can be made it is skipped, and says why.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "render/context.h"

namespace prairie {

class HeadlessTest : public testing::Test {
 protected:
  void SetUp() override;
  /// Mesa's software renderer, whose arithmetic is that of the CPU.
  static bool on_llvmpipe();

 private:
  std::optional<HeadlessContext> context_;
};

}  // namespace prairie
