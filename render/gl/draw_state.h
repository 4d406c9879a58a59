// How the fragments of a pass meet what has been drawn before: depth, blending, which sides are seen. The
// whole of it is set at once, so that no pass depends on what another left behind.
#pragma once

#include <cstdint>

namespace prairie {

/// Depth is reversed: near is 1, far is 0.
enum class DepthTest : std::uint8_t { kNone, kCloser, kCloserOrEqual, kFarther };

struct DrawState {
  DepthTest depth_test = DepthTest::kCloser;
  bool writes_depth = true;
  bool blends = false;       // over what is there, by the fragment's alpha; the target keeps its own alpha
  bool culls_backs = false;  // of closed meshes, whose triangles are counter-clockwise from outside
};

/// Over a picture, without regard to depth: tone curves, textures.
inline constexpr DrawState kOverAll{.depth_test = DepthTest::kNone, .writes_depth = false};

/// For all that is drawn from now on.
void set_draw_state(const DrawState& state);

}  // namespace prairie
