#include "tests/render/headless_test.h"

#include "files/error.h"

namespace prairie {

void HeadlessTest::SetUp() {
  try {
    context_.emplace(std::nullopt, ContextOptions{.debug = true});
    messages_.emplace();
  } catch (const NoSuitableOpenGl& fault) {
    GTEST_SKIP() << "no OpenGL 4.5: " << fault.what();
  }
}

void HeadlessTest::TearDown() {
  if (!messages_) return;
  for (const GlMessage& fault : messages_->faults()) ADD_FAILURE() << "OpenGL says " << line_of(fault);
}

bool HeadlessTest::on_llvmpipe() {
  return renderer_name().find("llvmpipe") != std::string::npos;
}

}  // namespace prairie
