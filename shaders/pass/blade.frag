#version 450 core
// Taken inside the blade: blades are narrower than pixels, and with several samples a pixel its middle would
// lie far outside the range of the vertices' light. Even so a triangle that is thinner than the grid on which
// it is rasterised may be seen where it is not, by its own reckoning: there it has the light of a corner.
layout(location = 0) centroid in vec3 radiance;
layout(location = 1) centroid in vec2 corner_weights;  // of two corners
layout(location = 2) flat in vec3 corner_radiance;
layout(location = 0) out vec4 color;

const float kBesideTriangle = 0.01;  // of a weight, for rounding

void main() {
  float least = min(min(corner_weights.x, corner_weights.y), 1.0 - corner_weights.x - corner_weights.y);
  color = vec4(least < -kBesideTriangle ? corner_radiance : radiance, 1.0);
}
