#version 450 core
layout(location = 0) in vec3 radiance;
layout(location = 1) flat in float rank;
layout(location = 0) out vec4 color;

void main() {
  color = vec4(radiance, rank);
}
