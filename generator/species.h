// A species of grass: what a blade of it is like on average and how much blades differ. The numbers that the
// kernels read lie in SpeciesParams (shaders/shared/species.glsl), one struct for both sides.
#pragma once

#include <string>

#include "shaders/shared/layouts.h"

namespace prairie {

struct Species {
  std::string name;
  SpeciesParams params{};
};

}  // namespace prairie
