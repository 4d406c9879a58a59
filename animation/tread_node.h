// What a node of trodden grass remembers, how a step presses it and how it rises again (G03 §4.2).
//
// F adds over the steps of a pass and over passes; a body of radius ε and weight 1 adds ε² F, which is 2 on
// the path of a long pass, whatever its radius. Blades lie down by θmax (1 − e^(−F/F0)). Recovery: F goes to
// that of the worn state as (1 − x)², x the share of the recovery time that has passed. What a step adds is
// new and x = 0; x of the sum is the mean weighted by F. So a small addition does not stop a recovery, and it
// matters little whether a step comes whole or in parts. G03 starts the interpolation anew with each step.
// Direction: the mean of E/F over what pressed the node until it was half flat. Further steps renew only the
// vertical part, so that crushed blades do not turn (G03). Wear, 0…1, is what treading leaves: it grows by
// the field that a node has ever felt, slows recovery and makes it incomplete.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace prairie {

struct TreadSettings {
  double spacing_m = 0.125;  // of the nodes, 0.05…0.5
  double reach_radii = 3.0;  // how far a body reaches beyond its path, in its radii, 1…6
  float field_scale = 0.6f;  // F0
  float most_tilt_rad = 1.45f;
  double recovery_s = 60.0;   // of lightly pressed, unworn grass, where no map says otherwise
  float load_slowing = 1.0f;  // heavily pressed grass takes (1 + this) times as long
  float worn_slowing = 2.0f;  // wholly worn grass takes (1 + this) times as long
  float wear_passes = 40.0f;  // passes of weight 1 over a node after which its wear is 1 − 1/e
  float worn_field = 0.4f;    // F of wholly worn grass at rest
};

/// Grass at rest is TreadNode{}. 32 bytes, plain data.
struct TreadNode {
  double start_s = 0.0;            // when the recovery began, or would have begun with all of `field`
  float field = 0.0f;              // F at that time beyond the worn state's; 0 at rest
  float recovery_s = 0.0f;         // from then to rest
  float blades_recovery_s = 0.0f;  // of the blades here, lightly pressed and unworn
  glm::vec2 direction{0.0f};       // mean of E/F, length √2 at most

  bool operator==(const TreadNode&) const = default;
};

/// What the bodies of a step do to a node.
struct TreadPush {
  float field = 0.0f;        // Σ weight ε² F
  glm::vec2 directed{0.0f};  // Σ weight ε² E
  float standing = 0.0f;     // field up to which standing bodies press
  glm::vec2 outward{0.0f};   // from the body that stands heaviest, unit length or 0
  bool held = false;         // touched by a body: does not rise meanwhile
};

/// Trodden grass to draw.
struct Tread {
  glm::vec2 lean_rad{0.0f};  // how far and where to blades are bent; fades with recovery
  float tilt_rad = 0.0f;     // how far blades lie down in all: also worn ones, which lie every way
  float wear = 0.0f;         // 0…1
};

/// F of the worn state.
inline float worn_field(const TreadSettings& settings, float wear) {
  return settings.worn_field * wear;
}

/// F beyond that of the worn state at a time not before the node was last pressed; falls with time, 0 once it
/// is at rest.
float field_of(const TreadNode& node, double time_s);

/// When the node, left alone, is at rest.
double rest_time_s(const TreadNode& node);

/// Applies the step from `from_s` to `to_s`. Needs `blades_recovery_s` where there is a push.
void press(const TreadSettings& settings, const TreadPush& push, double from_s, double to_s, TreadNode& node,
           float& wear);

Tread tread_of(const TreadSettings& settings, const TreadNode& node, float wear, double time_s);

/// The same of as many nodes as there are treads: (lean east, lean north, tilt, wear).
void treads_of(const TreadSettings& settings, std::span<const TreadNode> nodes, std::span<const float> wear,
               double time_s, std::span<glm::vec4> treads);

}  // namespace prairie
