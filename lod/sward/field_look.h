// What grows on a field, as means over it: what a renderer needs to know of its blades where it does not look
// at single ones.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "generator/meadow.h"
#include "lod/sward/sward_response.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// The species of a field and how much there is of each.
struct FieldMix {
  std::vector<SpeciesParams> species;    // with their greatest densities, `densest_per_m2`
  std::vector<double> densities_per_m2;  // means over the field; of a bare one 1 each, should somebody sow it
};

/// Reads the density maps.
FieldMix field_mix(const Meadow& meadow);

/// The layers of the mix, which has to outlive them.
std::vector<SwardLayer> layers_of(const FieldMix& mix);

struct FieldLook {
  glm::vec3 mean_albedo{0.0f};                   // of its leaves
  double projected_from_above = 0.5;             // leaf area seen straight from above per leaf area
  double density_per_leaf_area = 1.0;            // blades per square metre of leaf
  double height_m = 0.0;                         // mean height of standing blades
  double blade_width_m = 0.0;                    // mean
  std::vector<double> blade_area_from_above_m2;  // what one blade of each species shows from above
};

/// `response`: of the mix's layers.
FieldLook field_look(const FieldMix& mix, const SwardResponse& response);

}  // namespace prairie
