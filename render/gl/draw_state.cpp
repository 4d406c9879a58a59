#include "render/gl/draw_state.h"

#include <epoxy/gl.h>

namespace prairie {
namespace {

void switch_on(GLenum capability, bool on) {
  on ? glEnable(capability) : glDisable(capability);
}

GLenum depth_function(DepthTest test) {
  switch (test) {
    case DepthTest::kNone:
      break;
    case DepthTest::kCloser:
      return GL_GREATER;
    case DepthTest::kCloserOrEqual:
      return GL_GEQUAL;
    case DepthTest::kFarther:
      return GL_LESS;
  }
  return GL_ALWAYS;
}

}  // namespace

void set_draw_state(const DrawState& state) {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  switch_on(GL_DEPTH_TEST, state.depth_test != DepthTest::kNone);
  glDepthFunc(depth_function(state.depth_test));
  glDepthMask(state.writes_depth ? GL_TRUE : GL_FALSE);
  switch_on(GL_BLEND, state.blends);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  switch_on(GL_CULL_FACE, state.culls_backs);
}

}  // namespace prairie
