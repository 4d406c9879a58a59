// The struct layouts that C++ and GLSL share, read as C++: the files of this folder with GLM's types, and the
// proof that both sides see the same bytes (std430).
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace prairie {

namespace layouts {
using glm::ivec2;
using glm::mat4;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = glm::uint;

#include "shaders/shared/bindings.glsl"
#include "shaders/shared/blade.glsl"
#include "shaders/shared/planted_cell.glsl"
#include "shaders/shared/drawn_cell.glsl"
#include "shaders/shared/lod.glsl"
#include "shaders/shared/field_overlay.glsl"
#include "shaders/shared/view.glsl"
#include "shaders/shared/light.glsl"
#include "shaders/shared/field.glsl"
#include "shaders/shared/ground_patch.glsl"
#include "shaders/shared/grown_vertex.glsl"
#include "shaders/shared/line.glsl"
#include "shaders/shared/strip_tile.glsl"
#include "shaders/shared/strip_vertex.glsl"
#include "shaders/shared/solid.glsl"
#include "shaders/shared/species.glsl"
#include "shaders/shared/strip_scale.glsl"
#include "shaders/shared/sward_axes.glsl"
#include "shaders/shared/sway.glsl"
#include "shaders/shared/texels.glsl"
#include "shaders/shared/tile_morphs.glsl"
#include "shaders/shared/walker.glsl"

}  // namespace layouts

using layouts::Blade;
using layouts::DrawnCell;
using layouts::FieldParams;
using layouts::GroundPatchParams;
using layouts::GrownVertex;
using layouts::HeatSquare;
using layouts::kBrightest;
using layouts::kSwardDeepest;
using layouts::kSwardLowestSine;
using layouts::kSwayPeriodS;
using layouts::LightParams;
using layouts::LineParams;
using layouts::LodCoefficients;
using layouts::PlantedCell;
using layouts::SolidParams;
using layouts::SpeciesParams;
using layouts::StripTile;
using layouts::StripVertex;
using layouts::ViewParams;
using layouts::WalkerParams;
using layouts::WindArrow;

constexpr std::size_t kTexelBytes = 16;
static_assert(sizeof(Blade) == kTexelBytes * layouts::kBladeTexels);
static_assert(offsetof(Blade, lean) == 32);
static_assert(sizeof(DrawnCell) == kTexelBytes * layouts::kCellTexels);
static_assert(offsetof(DrawnCell, eye_from_tile_m) == 80);
static_assert(sizeof(ViewParams) == 208);
static_assert(offsetof(ViewParams, lod) == 144);
static_assert(sizeof(LightParams) == 96);
static_assert(offsetof(LightParams, zenith_radiance) == 64);
static_assert(sizeof(FieldParams) == 80);
static_assert(offsetof(FieldParams, flat_period_m) == 48);
static_assert(sizeof(HeatSquare) == 48);
static_assert(offsetof(HeatSquare, heat) == 32);
static_assert(sizeof(LineParams) == 48);
static_assert(offsetof(LineParams, color) == 32);
static_assert(sizeof(LodCoefficients) == 64);
static_assert(sizeof(GroundPatchParams) == 16);
static_assert(sizeof(GrownVertex) == kTexelBytes);
static_assert(sizeof(StripTile) == kTexelBytes * layouts::kStripTileTexels);
static_assert(sizeof(StripVertex) == kTexelBytes * layouts::kStripVertexTexels);
static_assert(sizeof(PlantedCell) == 80);
static_assert(offsetof(PlantedCell, clump_lattice) == 32);
static_assert(sizeof(SolidParams) == 96);
static_assert(offsetof(SolidParams, half_size_m) == 64);
static_assert(sizeof(SpeciesParams) == kTexelBytes * layouts::kSpeciesTexels);
static_assert(offsetof(SpeciesParams, tip_color) == 16);
static_assert(offsetof(SpeciesParams, height_m) == 64);
static_assert(sizeof(WalkerParams) == 16 * 57 + 80);
static_assert(offsetof(WalkerParams, skin) == 16 * layouts::kWalkerBoneRows);
static_assert(sizeof(WindArrow) == 32);

}  // namespace prairie
