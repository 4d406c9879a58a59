// FLIP's formulas as they are printed, in double, pixel by pixel and with kernels over the plane: slow,
// shares nothing with pictures/flip.cpp, and stands beside it as the expected result.
#pragma once

#include "pictures/flip.h"

namespace prairie {

enum class FlipTerms { kColor, kColorAndFeatures };

double flip_as_printed(const SrgbImage& reference, const SrgbImage& test, double pixels_per_degree,
                       FlipTerms terms = FlipTerms::kColorAndFeatures);

/// Of two pictures of one colour each, sRGB bytes: filters change nothing and there are no features.
double uniform_flip_as_printed(const std::uint8_t (&reference)[3], const std::uint8_t (&test)[3]);

}  // namespace prairie
