// What the driver says is heard, at once and with its severity.
#include "render/gl/gl_debug.h"

#include "tests/render/headless_test.h"

namespace prairie {
namespace {

using GlDebugTest = HeadlessTest;

TEST_F(GlDebugTest, HearsAnErrorAtOnce) {
  EXPECT_TRUE(messages().faults().empty());
  glEnable(GL_TEXTURE_2D);  // no capability of the core profile
  ASSERT_EQ(messages().faults().size(), 1u);
  const GlMessage fault = messages().faults().front();
  EXPECT_EQ(fault.severity, GlSeverity::kHigh);
  EXPECT_NE(fault.text.find("GL_INVALID_ENUM"), std::string::npos) << fault.text;
  EXPECT_TRUE(line_of(fault).starts_with("high ")) << line_of(fault);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  messages().clear();
  EXPECT_TRUE(messages().messages().empty());
}

TEST_F(GlDebugTest, TakesMediumForAFaultAndLowForNone) {
  const auto say = [](GLuint id, GLenum severity) {
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, id, severity, -1, "two\nlines");
  };
  say(1, GL_DEBUG_SEVERITY_NOTIFICATION);
  say(2, GL_DEBUG_SEVERITY_MEDIUM);
  ASSERT_EQ(messages().messages().size(), 2u);
  ASSERT_EQ(messages().faults().size(), 1u);
  EXPECT_EQ(line_of(messages().faults().front()), "medium 2: two lines");
  messages().clear();
}

TEST_F(GlDebugTest, IsStillAfterwards) {
  std::optional<GlMessageLog> log;
  log.emplace();  // takes the place of the fixture's
  log.reset();
  glEnable(GL_TEXTURE_2D);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_TRUE(messages().messages().empty());
}

}  // namespace
}  // namespace prairie
