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
float recovered_share(float passed_s, float recovery_s) {
  return std::min(std::max(passed_s / recovery_s, 0.0f), 1.0f);
}

float passed_s(const TreadNode& node, double time_s) {
  return static_cast<float>(time_s - node.start_s);
}

/// F `passed_s` after the recovery of `field` began. Without branches, so that it takes part in a vector
/// stage.
float field_after(float field, float passed_s, float recovery_s) {
  const float left = 1.0f - recovered_share(passed_s, recovery_s);
  const float now = field * (left * left);
  return field == 0.0f ? 0.0f : now;
}

float field_at(const TreadNode& node, double time_s) {
  return field_after(node.field, passed_s(node, time_s), node.recovery_s);
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

  const float share =
      before > 0.0f ? recovered_share(passed_s(node, to_s), node.recovery_s) * (before / after) : 0.0f;
  const float left = 1.0f - std::min(share, 0.999f);
  node.field = after / (left * left);
  node.recovery_s = recovery_time_s(settings, node, after, wear);
  node.start_s = to_s - static_cast<double>((1.0f - left) * node.recovery_s);
}

namespace {

inline Tread tread_at(const TreadSettings& settings, float bent, glm::vec2 direction, float wear) {
  Kernels kernels;
  const float worn = worn_field(settings, wear);
  const float worn_tilt_rad = kernels.tread_tilt(worn, settings.field_scale, settings.most_tilt_rad);
  const float tilt_rad = kernels.tread_tilt(worn + bent, settings.field_scale, settings.most_tilt_rad);
  // Where pushes from opposite sides cancel, blades have no direction to lean to.
  constexpr float kUndecided = 0.3f;
  const float length = std::max(std::sqrt(direction.x * direction.x + direction.y * direction.y), kUndecided);
  const float lean = bent > 0.0f ? (tilt_rad - worn_tilt_rad) / length : 0.0f;
  return {glm::vec2(direction.x * lean, direction.y * lean), tilt_rad, wear};
}

}  // namespace

Tread tread_of(const TreadSettings& settings, const TreadNode& node, float wear, double time_s) {
  return tread_at(settings, field_at(node, time_s), node.direction, wear);
}

namespace {

constexpr std::size_t kBlock = 16;

/// Nodes and their treads as the processor likes them.
struct TreadBlock {
  float passed_s[kBlock], field[kBlock], recovery_s[kBlock], east[kBlock], north[kBlock], wear[kBlock];
  float lean_east[kBlock], lean_north[kBlock], tilt_rad[kBlock];
};

PRAIRIE_VECTOR_STAGE void find_treads(const TreadSettings& settings, TreadBlock& block) {
  const TreadSettings same = settings;  // nothing that is stored may change it
  for (std::size_t n = 0; n < kBlock; ++n) {
    const float bent = field_after(block.field[n], block.passed_s[n], block.recovery_s[n]);
    const Tread tread = tread_at(same, bent, {block.east[n], block.north[n]}, block.wear[n]);
    block.lean_east[n] = tread.lean_rad.x;
    block.lean_north[n] = tread.lean_rad.y;
    block.tilt_rad[n] = tread.tilt_rad;
  }
}

}  // namespace

void treads_of(const TreadSettings& settings, std::span<const TreadNode> nodes, std::span<const float> wear,
               double time_s, std::span<glm::vec4> treads) {
  if (treads.size() < 4) {  // a block costs as much as four
    for (std::size_t n = 0; n < treads.size(); ++n) {
      const Tread tread = tread_of(settings, nodes[n], wear[n], time_s);
      treads[n] = {tread.lean_rad.x, tread.lean_rad.y, tread.tilt_rad, tread.wear};
    }
    return;
  }
  TreadBlock block{};
  for (std::size_t first = 0; first < treads.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, treads.size() - first);
    for (std::size_t n = 0; n < count; ++n) {
      const TreadNode& node = nodes[first + n];
      block.passed_s[n] = passed_s(node, time_s);
      block.field[n] = node.field;
      block.recovery_s[n] = node.recovery_s;
      block.east[n] = node.direction.x;
      block.north[n] = node.direction.y;
      block.wear[n] = wear[first + n];
    }
    find_treads(settings, block);
    for (std::size_t n = 0; n < count; ++n)
      treads[first + n] = {block.lean_east[n], block.lean_north[n], block.tilt_rad[n], block.wear[n]};
  }
}

}  // namespace prairie
