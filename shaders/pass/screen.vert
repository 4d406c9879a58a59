#version 450 core
// One triangle that covers the screen, at the far end of the depth range (reversed: 0).
layout(location = 0) out vec2 clip_xy;

void main() {
  clip_xy = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2)) * 2.0 - 1.0;
  gl_Position = vec4(clip_xy, 0.0, 1.0);
}
