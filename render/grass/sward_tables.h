// A field's look from afar (lod/sward/sward_response.h) where shaders find it: shaders/lib/sward_look.glsl.
#pragma once

#include <span>
#include <vector>

#include "generator/meadow.h"
#include "render/gl/gl_objects.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// What the frame block tells of a field's blades.
struct FieldLook {
  glm::vec3 mean_albedo{0.0f};         // of its leaves
  double projected_from_above = 0.5;   // leaf area seen straight from above per leaf area
  double density_per_leaf_area = 1.0;  // blades per square metre of leaf
  double height_m = 0.0;               // mean height of standing blades
  double blade_width_m = 0.0;
};

class SwardTables {
 public:
  explicit SwardTables(const Meadow& meadow);

  /// Makes the tables anew for a light: sun, ambients and horizon of the frame block.
  void set_light(const FrameParams& light);
  void bind() const;

  const FieldLook& field() const { return field_; }
  /// The species with what the renderer finds.
  std::span<const SpeciesParams> species() const { return species_; }
  /// What one blade of each species shows from above, m².
  std::span<const double> blade_area_from_above_m2() const { return blade_area_from_above_m2_; }

 private:
  std::vector<SpeciesParams> species_;
  std::vector<double> densities_per_m2_;  // means over the field
  std::vector<double> blade_area_from_above_m2_;
  FieldLook field_;
  GlTexture free_;
  GlTexture shaded_;
};

}  // namespace prairie
