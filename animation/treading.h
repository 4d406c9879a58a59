// Bodies that move over the grass press it down, and it rises again (G03 §4.2, §5.4). Each step of a body
// from P0 to P1 writes F and E (shaders/kernels/tread.glsl) to the nodes in its reach; between steps nodes
// that nothing touches cost nothing, for their state at a time follows from what they remember
// (animation/tread_node.h).
//
// Deterministic: what several bodies do to a node is summed in the order of their ids, whatever the order in
// which they are given and the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "animation/node_field.h"
#include "animation/tread_node.h"
#include "maps/node_grid.h"

namespace prairie {

struct PagePushes;
struct TreadPath;

/// A body's way in a step: a foot on the ground, a wheel, a stone. A body that stands has to_m = from_m; one
/// in the air is left out.
struct TreadStep {
  std::uint32_t id = 0;  // one step of each body at a time
  glm::dvec2 from_m{0.0};
  glm::dvec2 to_m{0.0};   // at most 100 m from `from_m`
  double radius_m = 0.1;  // 0.01…5
  double weight = 1.0;    // how heavily it presses: 0 not at all, 1 as a walker
};

/// All that changes; plain data to be copied out, kept and restored.
struct TreadState {
  double time_s = 0.0;
  NodeField<TreadNode> nodes;
  NodeField<float> wear;  // 0…1; same spacing

  bool operator==(const TreadState&) const = default;
};

class Treading {
 public:
  /// `recovery_s`: how long the blades of a place take to rise when lightly pressed; settings.recovery_s
  /// where the map has no data or none above 0. Throws BadInput on settings out of range.
  explicit Treading(const TreadSettings& settings, NodeGrid recovery_s = NodeGrid::uniform(0.0f));

  const TreadSettings& settings() const { return settings_; }
  const TreadState& state() const { return state_; }
  /// Another one whenever the state has become another.
  std::uint64_t revision() const { return revision_; }

  /// Throws BadInput, and changes nothing, if the state has other nodes or numbers out of range.
  void restore(TreadState state);

  /// Moves from the state's time to `to_s` while the bodies make their steps. Throws BadInput, and changes
  /// nothing, if time goes backwards, a number is not finite or out of range, or two steps have the same id.
  void step(std::span<const TreadStep> steps, double to_s);

  /// At the state's time: bilinear between nodes, and at a node.
  Tread sample(glm::dvec2 position_m) const;
  /// The same of many places, which is cheapest where neighbours follow one another.
  void sample(std::span<const glm::dvec2> positions_m, std::span<Tread> treads) const;
  Tread at(NodeIndex node) const;

  /// At the state's time, for textures: (lean east, lean north, tilt, wear) of every node of `rect`, row by
  /// row from south-west; rad and 0…1. Cheap where nothing was trodden.
  void read(const NodeRect& rect, std::span<glm::vec4> out) const;

  /// Wear of every node of `rect` (column east, row north), row by row from south-west.
  void read_wear(const NodeRect& rect, std::span<float> out) const;
  /// Replaces it; throws BadInput, and changes nothing, where a value is not in 0…1.
  void write_wear(const NodeRect& rect, std::span<const float> wear);

  /// Memory that fields hold.
  std::size_t bytes() const { return state_.nodes.bytes() + state_.wear.bytes(); }

 private:
  struct Visit;
  struct Passage;
  struct VisitedPage;

  static void add_visits(const TreadPath& path, std::uint32_t index, double spacing_m,
                         std::vector<Visit>& visits);
  std::vector<VisitedPage> visited_pages(const Passage& passage);
  void press_page(const Passage& passage, const VisitedPage& page, PagePushes& pushes) const;
  float blades_recovery_s(PageIndex page, std::size_t slot) const;

  TreadSettings settings_;
  NodeGrid recovery_s_;
  TreadState state_;
  std::uint64_t revision_ = 1;
};

}  // namespace prairie
