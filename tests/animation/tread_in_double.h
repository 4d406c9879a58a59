// shaders/kernels/tread.glsl read once more, in double: shows that its formulas hold to more digits than
// floats have.
#pragma once

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>

// The kernels' literals are floats; those of this file are all exact.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdouble-promotion"

namespace prairie::in_double {

using glm::sqrt;
using vec2 = glm::dvec2;

inline double max(double a, double b) {
  return a > b ? a : b;
}
inline double min(double a, double b) {
  return a < b ? a : b;
}
inline double falling_exponential(double x) {
  return std::exp(-x);
}

#define precise
#define float double
struct TreadInDouble {
#include "shaders/kernels/tread.glsl"
};
#undef float
#undef precise

}  // namespace prairie::in_double

#pragma GCC diagnostic pop
