#include "chain_cases.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace prairie {

std::array<glm::dvec3, 4> Arc::directions() const {
  const glm::dvec3 across = glm::cross(axis, foot);
  std::array<glm::dvec3, 4> result;
  for (int i = 0; i < 4; ++i) {
    const double angle = turning * (0.125 + 0.25 * i);
    result[i] = foot * std::cos(angle) + across * std::sin(angle);
  }
  return result;
}

Arc leaning_arc(double lean_rad, double azimuth_rad, double turning_rad, double bend_rad) {
  const glm::dvec3 towards(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dvec3 foot = up * std::cos(lean_rad) + towards * std::sin(lean_rad);
  const glm::dvec3 over = glm::cross(up, towards);  // leans further
  const glm::dvec3 aside = glm::cross(foot, over);
  return {foot, over * std::cos(bend_rad) + aside * std::sin(bend_rad), turning_rad};
}

ChainVectors chain_vectors(const std::array<glm::dvec3, 4>& v) {
  return {glm::vec3(v[0]), glm::vec3(v[1]), glm::vec3(v[2]), glm::vec3(v[3])};
}

std::array<glm::dvec3, 4> vectors_of(const ChainVectors& v) {
  return {glm::dvec3(v.v1), glm::dvec3(v.v2), glm::dvec3(v.v3), glm::dvec3(v.v4)};
}

glm::dvec3 tip_share(const ChainVectors& directions) {
  const auto t = vectors_of(directions);
  return (t[0] + t[1] + t[2] + t[3]) * 0.25;
}

double energy_of(const ChainVectors& rest, const ChainMotion& motion, const ChainTraits& traits) {
  const auto turn = vectors_of(motion.turn), rate = vectors_of(motion.rate), r = vectors_of(rest);
  const double seconds2 = static_cast<double>(traits.half_segment_m) / 9.81;
  const double stiffness = std::max(static_cast<double>(traits.stiffness), 20.0);
  double energy = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double inertia = 4.0 * (3 - std::max(i, j)) + (i == j ? 4.0 / 3.0 : 2.0);
      energy += 0.5 * seconds2 * inertia * glm::dot(rate[i], rate[j]);
    }
    const glm::dvec3 bend = i == 0 ? turn[0] : turn[i] - turn[i - 1];
    energy += 0.5 * (i == 0 ? 2.0 : 1.0) * stiffness * glm::dot(bend, bend);
    const double angle = glm::length(turn[i]);
    const glm::dvec3 axis = angle > 0.0 ? turn[i] / angle : glm::dvec3(0.0);
    const double z = r[i].z * std::cos(angle) + glm::cross(axis, r[i]).z * std::sin(angle) +
                     axis.z * glm::dot(axis, r[i]) * (1.0 - std::cos(angle));
    energy += (7.0 - 2.0 * i) * z;
  }
  return energy;
}

double uniform(std::mt19937& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

double log_uniform(std::mt19937& random, double least, double most) {
  return std::exp(uniform(random, std::log(least), std::log(most)));
}

glm::dvec3 unit_vector(std::mt19937& random) {
  const double z = uniform(random, -1.0, 1.0), heading = uniform(random, 0.0, 6.283185307);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(heading), r * std::sin(heading), z};
}

ChainTraits any_traits(std::mt19937& random) {
  const double mean_length_m = log_uniform(random, 0.005, 6.0);
  const double width_m = log_uniform(random, 1e-4, 0.1), mass_g = log_uniform(random, 1e-4, 1000.0);
  ChainTraits traits;
  traits.half_segment_m = static_cast<float>(mean_length_m * log_uniform(random, 0.05, 1.95) / 8.0);
  traits.stiffness = static_cast<float>(log_uniform(random, 0.1, 1e4) * log_uniform(random, 0.05, 1.95));
  traits.damping_ratio =
      static_cast<float>(uniform(random, 0.0, 1.0) < 0.1 ? 0.0 : uniform(random, 0.0, 2.0));
  traits.drag = chain_drag(static_cast<float>(width_m), static_cast<float>(mean_length_m),
                           static_cast<float>(mass_g), static_cast<float>(uniform(random, 0.0, 2.0)));
  return traits;
}

}  // namespace prairie
