#version 450 core
// The colour of a line over the picture. Unlit: a colour means the same in any light.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = kOverlayShown) uniform float shown;
layout(location = kLineHalfWidth) uniform float half_width_px;

layout(location = 0) flat in vec4 line_color;
layout(location = 1) in float across_px_w;
layout(location = 0) out vec4 color;

void main() {
  float cover = clamp(half_width_px + 0.5 - abs(across_px_w * gl_FragCoord.w), 0.0, 1.0);
  color = vec4(line_color.rgb / light.exposure, line_color.a * cover * shown);
}
