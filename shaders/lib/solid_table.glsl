// The solids of a frame (render/things/solid_pass.h).
#include "shaders/shared/solid.glsl"

layout(std430, binding = kThingBuffer) readonly buffer SolidTable {
  SolidParams solids[];
};

mat3 scene_from_body(SolidParams solid) {
  return mat3(solid.forward, solid.left, solid.up);
}
