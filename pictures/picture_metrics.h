// Measures by which two pictures of the same grass, or the frames of one flight over it, are compared: mean
// colour, how much texture there is, how evenly a sequence changes. All of them work in linear light;
// "luminance" is 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). A block is a square of block_px × block_px
// pixels; blocks that do not fit whole, at the right and at the bottom, are left out. How different two
// pictures look is in pictures/flip.h.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pictures/pixel_rect.h"

namespace prairie {

/// A picture in linear light: rows from the top, three floats a pixel.
struct LinearImage {
  int width = 0;
  int height = 0;
  std::span<const float> rgb;
};

/// The mean of each channel. `rect` lies in the picture and holds at least one pixel, here and below.
glm::dvec3 mean_color(const LinearImage& image, const PixelRect& rect);

/// The standard deviation, over the blocks of `rect` (at least one, counted from its top left), of a block's
/// mean luminance from the plane that fits those means best by least squares: haze and perspective darken a
/// picture steadily, which is no texture.
double luminance_deviation(const LinearImage& image, const PixelRect& rect, int block_px);

/// The mean luminance of every block of the picture, row by row from the top.
std::vector<double> block_luminances(const LinearImage& image, int block_px);

/// How evenly a sequence changes. The change of a step, from one frame to the next, is the largest change of
/// any block's mean luminance; a tier that pops makes one step's change stand out of those around it.
struct StepEvenness {
  double largest = 0.0;
  double median = 0.0;
  double ratio = 1.0;  // largest / median; 1 if nothing ever changes, infinite if only few steps change
  std::size_t largest_frame = 0;  // to which the largest step leads
  std::size_t largest_block = 0;  // and the block that took it
};

/// `frames`: of each the block_luminances, of two or more frames of one size.
StepEvenness step_evenness(std::span<const std::vector<double>> frames);

}  // namespace prairie
