// Several samples a pixel: frames that are shifted by parts of a pixel, read back and averaged in linear
// light.
#pragma once

#include <epoxy/gl.h>

#include <glm/vec2.hpp>
#include <vector>

namespace prairie {

/// The shift of clip space for one of so many samples, evenly spread for any number of them.
glm::vec2 sample_shift(int sample, int samples, glm::ivec2 size_px);

class SampleSum {
 public:
  explicit SampleSum(glm::ivec2 size_px);

  /// Adds what a framebuffer of that size holds.
  void add(GLuint framebuffer);
  /// The mean so far: four values a pixel, rows from the bottom, as OpenGL has them.
  std::vector<float> mean() const;

 private:
  glm::ivec2 size_px_;
  std::vector<float> pixels_;
  std::vector<double> sum_;
  int samples_ = 0;
};

}  // namespace prairie
