#include "tests/render/headless_test.h"

#include "maps/error.h"

namespace prairie {

void HeadlessTest::SetUp() {
  try {
    context_.emplace(std::nullopt);
  } catch (const NoSuitableOpenGl& fault) {
    GTEST_SKIP() << "no OpenGL 4.5: " << fault.what();
  }
}

bool HeadlessTest::on_llvmpipe() {
  return renderer_name().find("llvmpipe") != std::string::npos;
}

}  // namespace prairie
