// The struct layouts that C++ and GLSL share, read as C++: the files of this folder with GLM's types, and the proof that
// both sides see the same bytes (std430).
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace prairie {

namespace layouts {
using glm::ivec2;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = glm::uint;

#include "shaders/shared/blade.glsl"
#include "shaders/shared/planted_cell.glsl"
#include "shaders/shared/species.glsl"

}  // namespace layouts

using layouts::Blade;
using layouts::PlantedCell;
using layouts::SpeciesParams;

static_assert(sizeof(Blade) == 64);
static_assert(offsetof(Blade, lean) == 32);
static_assert(sizeof(PlantedCell) == 80);
static_assert(offsetof(PlantedCell, clump_lattice) == 32);
static_assert(sizeof(SpeciesParams) == 128);
static_assert(offsetof(SpeciesParams, tip_color) == 16);
static_assert(offsetof(SpeciesParams, height_m) == 64);

}  // namespace prairie
