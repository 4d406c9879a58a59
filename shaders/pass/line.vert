#version 450 core
// A corner of a line's strip on the screen (render/overlays/line_pass.h): what lies before the near plane is
// cut off, and half the width and half a pixel more, over which the edge fades, are laid to each side.
#include "shaders/lib/layouts.glsl"
#include "shaders/shared/line.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(std430, binding = kThingBuffer) readonly buffer Lines {
  LineParams lines[];
};

layout(location = kLineSize) uniform vec2 size_px;
layout(location = kLineHalfWidth) uniform float half_width_px;

layout(location = 0) flat out vec4 line_color;
// Pixels from the line's middle times w: times 1/w it is even across the screen. `noperspective` would say so
// as well, but Mesa's clipper loses it on upright edges.
layout(location = 1) out float across_px_w;

void main() {
  LineParams line = lines[gl_VertexID / 6];
  vec4 start = view.clip_from_eye * vec4(line.start_from_eye_m, 1.0);
  vec4 end = view.clip_from_eye * vec4(line.end_from_eye_m, 1.0);
  // Depth is reversed: z = w on the near plane, and w − z grows behind it.
  float start_behind = start.w - start.z, end_behind = end.w - end.z;
  line_color = line.color;
  across_px_w = 0.0;
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // out of sight
  if (max(start_behind, end_behind) <= 0.0) return;
  if (start_behind < 0.0)
    start = mix(start, end, start_behind / (start_behind - end_behind));
  else if (end_behind < 0.0)
    end = mix(end, start, end_behind / (end_behind - start_behind));

  vec2 along_px = (end.xy / end.w - start.xy / start.w) * size_px;
  float length_px = length(along_px);
  vec2 along = length_px > 0.0 ? along_px / length_px : vec2(1.0, 0.0);
  int corners[6] = int[6](0, 1, 3, 0, 3, 2);
  int corner = corners[gl_VertexID % 6];
  float reach_px = half_width_px + 0.5;
  float across_px = corner / 2 == 0 ? -reach_px : reach_px;
  gl_Position = corner % 2 == 0 ? start : end;
  gl_Position.xy += (2.0 * across_px * vec2(-along.y, along.x) / size_px + view.jitter) * gl_Position.w;
  across_px_w = across_px * gl_Position.w;
}
