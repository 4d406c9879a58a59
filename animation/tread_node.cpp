#include "animation/tread_node.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "generator/vector_stage.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// How fast a body that begins to stand presses the grass under it.
constexpr float kPressingS = 0.05f;

// On the path of a long pass of weight 1.
constexpr float kFieldOfPass = 2.0f;

// Flat to a thousandth of a radian; no number of passes makes it flatter, and recovery is not to wait for
// them.
float most_field(const TreadSettings& settings) {
  return 8.0f * settings.field_scale;
}

// Blades are crushed, and keep their direction, where they lie half down.
float crushed_field(const TreadSettings& settings) {
  return 0.69314718f * settings.field_scale;
}

/// 1 − e^(−x) for x ≥ 0. A step wears little, and for that a few terms of the series are exact and faster.
float grown_share(float x) {
  if (x < 0.03125f) return x * (1.0f - x * (0.5f - x * (0.16666667f - x * 0.041666668f)));
  return 1.0f - Kernels{}.falling_exponential(x);
}

/// Share of the recovery that has passed, 0…1.
float recovered_share(const TreadNode& node, double time_s) {
  const float passed_s = static_cast<float>(time_s - node.start_s);
  return std::min(std::max(passed_s / node.recovery_s, 0.0f), 1.0f);
}

// Without branches, so that it takes part in a vector stage.
float field_at(const TreadNode& node, double time_s) {
  const float left = 1.0f - recovered_share(node, time_s);
  const float field = node.field * (left * left);
  return node.field == 0.0f ? 0.0f : field;
}

/// Load and wear make it longer.
float recovery_time_s(const TreadSettings& settings, const TreadNode& node, float field, float wear) {
  const float load = field / (field + 2.0f * settings.field_scale);
  return node.blades_recovery_s * (1.0f + settings.load_slowing * load) *
         (1.0f + settings.worn_slowing * wear);
}

}  // namespace

float field_of(const TreadNode& node, double time_s) {
  return field_at(node, time_s);
}

double rest_time_s(const TreadNode& node) {
  return node.field == 0.0f ? node.start_s : node.start_s + static_cast<double>(node.recovery_s);
}

void press(const TreadSettings& settings, const TreadPush& push, double from_s, double to_s, TreadNode& node,
           float& wear) {
  // Grass under a body does not rise: its recovery waits for the length of the step.
  if (push.held && node.field > 0.0f) node.start_s = std::min(node.start_s + (to_s - from_s), to_s);
  const float before = field_at(node, to_s);

  float added = push.field;
  glm::vec2 directed = push.directed;
  if (const float missing = push.standing - (before + added); missing > 0.0f) {
    const float passed = static_cast<float>(to_s - from_s) / kPressingS;
    const float pressed = missing * grown_share(passed);
    added += pressed;
    directed += push.outward * (pressed * 1.41421356f);
  }
  if (!(added > 0.0f)) return;
  assert(node.blades_recovery_s > 0.0f);

  // Of the field, what becomes the worn state's does not count twice.
  const float unworn = 1.0f - wear;
  const float new_wear = wear + unworn * grown_share(added / (kFieldOfPass * settings.wear_passes));
  const float worn_more = std::max(worn_field(settings, new_wear) - worn_field(settings, wear), 0.0f);
  wear = std::min(new_wear, 1.0f);
  const float after = std::min(before + std::max(added - worn_more, 0.0f), most_field(settings));
  if (!(after > 0.0f)) return;

  const float crushed = crushed_field(settings);
  const float had = std::min(before, crushed), has = std::min(after, crushed);
  if (has > had) node.direction = (node.direction * had + directed * ((has - had) / added)) / has;

  const float share = before > 0.0f ? recovered_share(node, to_s) * (before / after) : 0.0f;
  const float left = 1.0f - std::min(share, 0.999f);
  node.field = after / (left * left);
  node.recovery_s = recovery_time_s(settings, node, after, wear);
  node.start_s = to_s - static_cast<double>((1.0f - left) * node.recovery_s);
}

namespace {

inline Tread tread_at(const TreadSettings& settings, const TreadNode& node, float wear, double time_s) {
  Kernels kernels;
  const float bent = field_at(node, time_s);
  const float worn = worn_field(settings, wear);
  const float worn_tilt_rad = kernels.tread_tilt(worn, settings.field_scale, settings.most_tilt_rad);
  const float tilt_rad = kernels.tread_tilt(worn + bent, settings.field_scale, settings.most_tilt_rad);
  // Where pushes from opposite sides cancel, blades have no direction to lean to.
  constexpr float kUndecided = 0.3f;
  const glm::vec2 d = node.direction;
  const float length = std::max(std::sqrt(d.x * d.x + d.y * d.y), kUndecided);
  const float lean = bent > 0.0f ? (tilt_rad - worn_tilt_rad) / length : 0.0f;
  return {glm::vec2(d.x * lean, d.y * lean), tilt_rad, wear};
}

}  // namespace

Tread tread_of(const TreadSettings& settings, const TreadNode& node, float wear, double time_s) {
  return tread_at(settings, node, wear, time_s);
}

PRAIRIE_VECTOR_STAGE void treads_of(const TreadSettings& settings, std::span<const TreadNode> nodes,
                                    std::span<const float> wear, double time_s, std::span<glm::vec4> treads) {
  for (std::size_t n = 0; n < treads.size(); ++n) {
    const Tread tread = tread_at(settings, nodes[n], wear[n], time_s);
    treads[n] = {tread.lean_rad.x, tread.lean_rad.y, tread.tilt_rad, tread.wear};
  }
}

}  // namespace prairie
