// How a sward looks from afar: the mean colour of the blades that one sees of it and the share of a pixel
// that they cover, by view direction and density, found without drawing. The flat tier (G03 §3.5) and the
// strips (G03 §3.4) take their colours from it, so that they look as the blades do that they stand for.
//
// Neither paper says how to find that colour. Here the sward is a Poisson canopy (Nilson 1971): leaf area
// thrown at random at every height, so that of what stands at height z one sees e^(−τ(z)), with τ the leaf
// area above z, projected along the view, per ground area seen. What stands at each height and how it is lit
// comes from sample blades (lod/sward/sward_sample.h), turned, widened and lit as shaders/pass/grow.comp
// does.
//
//   leaf_area = Σ density · Layer::blade_area_m2                        m² of leaf per m² of ground
//   τ         = leaf_area · G(θ) / sin θ          θ: the view's elevation above the ground's plane
//   cover     = 1 − e^(−τ)
//   colour    = free + shade · (shaded − free)    shade: shade_of(density of all species, …), lighting.glsl
//
// Colours are radiance on level ground, without haze. The sward is alike in all directions, so that only the
// angle φ between the horizontal directions towards the eye and towards the sun counts: 0 with the sun in the
// viewer's back, π looking towards it.
//
// Tufts need no correction: against planted blades, 100 to 2500 per m², seen ray by ray from 1° to 90°,
// colour is off by 4 % at most and 1 % on average, cover by 0.012
// (tests/render/grass/sward_response_test.cpp). Blades have 16 segments there; coarser meshes keep their area
// and light (shaders/kernels/blade_mesh.glsl).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "shaders/shared/layouts.h"

namespace prairie {

/// A species of a mix.
struct SwardLayer {
  const SpeciesParams* species = nullptr;
  double density_per_m2 = 0.0;  // only the ratios between the layers matter
};

/// Nodes are evenly spaced in the coordinates of `sward_place`, which says where each lies.
struct SwardResponse {
  static constexpr int kElevations = layouts::kSwardElevations;
  static constexpr int kAzimuths = layouts::kSwardAzimuths;
  static constexpr int kDepths = layouts::kSwardDepths;

  /// [depth][azimuth][elevation], elevation fastest: a 3-D texture of that width, height and depth.
  struct Colors {
    std::vector<glm::vec4> free;    // rgb: radiance of blades that nothing shades
    std::vector<glm::vec4> shaded;  // rgb: of blades in the shade of a dense sward
  };
  struct Layer {
    double blade_area_m2 = 0.0;    // one side of a blade, mean
    std::vector<float> projected;  // [elevation]: G of this species alone
    Colors colors;                 // of what one sees of this species; a: its share of what is covered
  };

  std::vector<float> projected;  // [elevation]: G, leaf area seen along the view per one-sided leaf area
  Colors colors;                 // of the mix; a: G again, the same at every azimuth and depth
  std::vector<Layer> layers;     // as given
};

/// At least one layer
/// has a density above 0. The same whatever the number of threads.
SwardResponse sward_response(std::span<const SwardLayer> layers, const LightParams& light);

/// Coordinates of the tables, each in [0, 1] from the first node to the last: x elevation, y azimuth, z
/// optical depth. A texture with n texels along an axis is read at (c · (n − 1) + ½) / n.
glm::vec3 sward_place(double sin_elevation, double azimuth_to_sun_rad, double optical_depth);

}  // namespace prairie
