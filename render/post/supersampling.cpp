#include "render/post/supersampling.h"

#include <cassert>
#include <cstddef>

namespace prairie {
namespace {

double radical_inverse(int index, int base) {
  double result = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

std::size_t value_count(glm::ivec2 size_px) {
  return std::size_t{4} * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
}

}  // namespace

glm::vec2 sample_shift(int sample, int samples, glm::ivec2 size_px) {
  if (samples == 1) return glm::vec2(0.0f);
  const glm::dvec2 shift((sample + 0.5) / samples - 0.5, radical_inverse(sample, 2) + 0.5 / samples - 0.5);
  return glm::vec2(2.0 * shift / glm::dvec2(size_px));
}

SampleSum::SampleSum(glm::ivec2 size_px)
    : size_px_(size_px), pixels_(value_count(size_px)), sum_(value_count(size_px), 0.0) {}

void SampleSum::add(GLuint framebuffer) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadPixels(0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_FLOAT, pixels_.data());
  for (std::size_t n = 0; n < sum_.size(); ++n) sum_[n] += static_cast<double>(pixels_[n]);
  ++samples_;
}

std::vector<float> SampleSum::mean() const {
  assert(samples_ > 0);
  std::vector<float> mean(sum_.size());
  for (std::size_t n = 0; n < sum_.size(); ++n) mean[n] = static_cast<float>(sum_[n] / samples_);
  return mean;
}

}  // namespace prairie
