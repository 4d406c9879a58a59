// The walkers of a frame (render/things/walker_pass.h).
#include "shaders/shared/walker.glsl"

layout(std430, binding = kThingBuffer) readonly buffer WalkerTable {
  WalkerParams walkers[];
};
