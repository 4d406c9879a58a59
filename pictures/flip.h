// How different two pictures look to somebody who flips between them: LDR-FLIP, after Andersson, Nilsson,
// Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), with the constants printed there. Detail that is
// too fine to be seen from the distance given is forgiven; lost or added edges and points weigh more than a
// difference of colour alone.
#pragma once

#include <cstdint>
#include <span>

namespace prairie {

/// A picture as sRGB bytes: rows from the top, three bytes a pixel.
struct SrgbImage {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgb;
};

/// The mean over all pixels of FLIP's error: 0 for equal pictures, at most 1, the same if the two are
/// exchanged. Both pictures are of one size and not empty. `pixels_per_degree` (at least 1) are those of a
/// degree of the viewer's field of view; the paper's viewer sits 0.7 m from a screen 0.7 m wide of 3840
/// pixels. Independent of the number of threads.
double mean_flip(const SrgbImage& reference, const SrgbImage& test, double pixels_per_degree = 67.02);

}  // namespace prairie
