#include "world/lattice_noise.h"

#include <cmath>

namespace prairie {
namespace {

// Finaliser of SplitMix64 (Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number Generators).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

double node_value(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  const std::uint64_t column = mixed(seed + 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(i));
  const std::uint64_t bits = mixed(column + 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(j));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

double quintic(double t) {
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

double between(double a, double b, double weight) {
  return a + (b - a) * weight;
}

}  // namespace

double lattice_noise(std::uint64_t seed, glm::dvec2 position) {
  const double column = std::floor(position.x);
  const double row = std::floor(position.y);
  const auto i = static_cast<std::int64_t>(column);
  const auto j = static_cast<std::int64_t>(row);
  const double u = quintic(position.x - column);
  const double v = quintic(position.y - row);
  return between(between(node_value(seed, i, j), node_value(seed, i + 1, j), u),
                 between(node_value(seed, i, j + 1), node_value(seed, i + 1, j + 1), u), v);
}

double layered_noise(std::uint64_t seed, glm::dvec2 position) {
  // Each octave turned by atan(3/4), so that the lattices' directions do not show.
  const auto turned = [](glm::dvec2 p) { return glm::dvec2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y); };
  const glm::dvec2 second = turned(2.0 * position);
  const glm::dvec2 third = turned(2.0 * second);
  const double sum = lattice_noise(seed, position) + 0.5 * lattice_noise(seed + 1, second) +
                     0.25 * lattice_noise(seed + 2, third);
  return sum / 1.75;
}

}  // namespace prairie
