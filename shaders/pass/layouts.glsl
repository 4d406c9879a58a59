// All shared layouts, in the order in which GLSL needs them.
#include "shaders/shared/blade.glsl"
#include "shaders/shared/planted_cell.glsl"
#include "shaders/shared/drawn_cell.glsl"
#include "shaders/shared/lod.glsl"
#include "shaders/shared/frame.glsl"
#include "shaders/shared/posed_blade.glsl"
#include "shaders/shared/species.glsl"
#include "shaders/shared/texels.glsl"
