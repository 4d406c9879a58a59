// All kernels, in the order in which GLSL needs them; before it, a shader provides `vec4 table_texel(uint
// texel)`.
#include "shaders/kernels/random.glsl"
#include "shaders/kernels/sequence.glsl"
#include "shaders/kernels/quarter.glsl"
#include "shaders/kernels/interpolation.glsl"
#include "shaders/kernels/trigonometry.glsl"
#include "shaders/kernels/warp.glsl"
#include "shaders/kernels/clump.glsl"
#include "shaders/kernels/cell_ground.glsl"
#include "shaders/kernels/features.glsl"
#include "shaders/kernels/plant.glsl"
#include "shaders/kernels/tiers.glsl"
#include "shaders/kernels/weight.glsl"
#include "shaders/kernels/pose.glsl"
#ifdef MOVING
#include "shaders/kernels/pressed.glsl"
#endif
#include "shaders/kernels/hermite.glsl"
#include "shaders/kernels/chain.glsl"
#ifdef SWAYING_BLADES
#include "shaders/kernels/rotation_vector.glsl"
#include "shaders/kernels/chain_matrix.glsl"
#include "shaders/kernels/chain_motion.glsl"
#include "shaders/kernels/chain_virtual.glsl"
#endif
#include "shaders/kernels/blade_surface.glsl"
#include "shaders/kernels/color.glsl"
#include "shaders/kernels/radiance.glsl"
#include "shaders/kernels/lighting.glsl"
#include "shaders/kernels/blade_mesh.glsl"
#include "shaders/kernels/tone.glsl"
