// What has come over the grass of a place: frost, drought, dew, blight. Primitives with 2D masks that change
// the colour and the stiffness of the grass which they cover (G03 §4.1). Where they overlap these features
// are averaged, not summed as wind is. With w_i = mask_i · strength_i, the weight of primitive i at a node,
// c_i and s_i its factors on colour and stiffness, and 1 those of grass that nothing covers:
//
//   colour        = (max(1 − Σ w_i, 0) · 1 + Σ w_i c_i) / max(1, Σ w_i)
//   ln stiffness  = Σ w_i ln s_i / max(1, Σ w_i)
//
// so that a primitive fades into untouched grass at its border, and where several cover a node in full each
// has an equal say. Stiffness is averaged in the logarithm: half as stiff and twice as stiff make as stiff as
// ever. Sums are taken in the order in which the primitives are listed; another order changes nothing but
// rounding.
//
// All are pure functions of place and time, and cost nothing at nodes that they do not reach.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "animation/node_block.h"

namespace prairie {

/// A disc, which may travel.
struct Condition {
  glm::dvec2 centre_m{0.0};  // at `start_s`
  glm::dvec2 velocity_m_per_s{0.0};
  double radius_m = 10.0;
  double edge_m = 3.0;  // within the radius, over which the mask falls smoothly to 0; at most the radius
  double start_s = 0.0;
  double duration_s = 0.0;        // 0: for ever
  double fade_s = 0.0;            // in which it comes and goes, each at most half of the duration
  glm::vec3 color_factor{1.0f};   // on the albedo of blades, linear, 0…4
  double stiffness_factor = 1.0;  // 0.1…10
};

/// Throws BadInput, `name` and the field in it, on a number that is not finite or out of range.
void check(const Condition& condition, const std::string& name);

/// From then on it does nothing; infinite for one that lasts.
double end_s(const Condition& condition);

/// A condition at one time: what is the same for all places.
struct PresentCondition {
  glm::dvec2 centre_m;
  double radius_m;
  double edge_m;
  float strength;            // by age, 0…1
  glm::vec3 color_change;    // of the factor from 1
  float log_stiffness;       // of the factor
  glm::dvec2 low_m, high_m;  // box of the ground outside which it does nothing

  bool operator==(const PresentCondition&) const = default;
};

/// Nothing if it does nothing anywhere at that time.
std::optional<PresentCondition> present_condition(const Condition& condition, double time_s);
/// Those of them that do something at that time, in their order.
std::vector<PresentCondition> present_conditions(std::span<const Condition> conditions, double time_s);

/// Its weight at a place, 0…1: 0 at its border, with a continuous slope.
float weight_at(const PresentCondition& condition, glm::dvec2 position_m);

/// The averaged features of a node; factors.
struct GrassCondition {
  glm::vec3 color_factor{1.0f};
  float stiffness_factor = 1.0f;

  bool operator==(const GrassCondition&) const = default;
};

GrassCondition grass_condition(std::span<const PresentCondition> conditions, glm::dvec2 position_m);

/// The features of every node of a block, row by row from south-west, as grass_condition has them. Returns at
/// how many nodes a condition was evaluated: those in the conditions' boxes, counted for each.
std::size_t fill_conditions(std::span<const PresentCondition> conditions, const NodeBlock& nodes,
                            std::span<GrassCondition> out);

}  // namespace prairie
