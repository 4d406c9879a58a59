#version 450 core
// Taken inside the blade: blades are narrower than pixels, and with several samples a pixel its middle would
// lie far outside the range of the vertices' light.
layout(location = 0) centroid in vec3 radiance;
layout(location = 0) out vec4 color;

void main() {
  color = vec4(radiance, 1.0);
}
