// A grid of nodes that carry one feature of the field (density, blade height, bend, a colour's channels),
// bilinear between nodes (G03 §3.1). Node (0, 0) is south-west, columns run east, rows run north.
//
// A node without data holds NaN. The nodes lie in memory, or in a temporary file where the map is
// larger than its share of the memory budget; callers cannot tell which, except by speed: read blocks, not
// single nodes.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

namespace prairie {

/// Where the nodes of a grid lie in the scene (metres; x east, y north).
struct GridFrame {
  int columns = 0;
  int rows = 0;
  double spacing_m = 1.0;
  glm::dvec2 origin_m{0.0};  // position of node (0, 0)
  bool repeats = false;      // period = columns · spacing_m, rows · spacing_m

  /// Largest position that still lies between nodes (meaningless where the grid repeats).
  glm::dvec2 far_corner_m() const { return origin_m + spacing_m * glm::dvec2(columns - 1, rows - 1); }
};

/// A block of nodes, in node indices; may reach beyond the grid.
struct NodeRect {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;
};

/// Where nodes come from when they do not lie in memory.
class NodeSource {
 public:
  virtual ~NodeSource() = default;
  /// Writes `rect` (wholly inside the grid), channel-interleaved, row by row from south; NaN = no data.
  /// Thread-safe.
  virtual void read(const NodeRect& rect, std::span<float> out) const = 0;
};

class NodeGrid {
 public:
  NodeGrid() = default;
  /// `values`: rows from south, columns from west, channels interleaved; NaN = no data.
  NodeGrid(GridFrame frame, int channels, std::vector<float> values);
  /// `may_have_gaps`: false if the source is known to hold no NaN.
  NodeGrid(GridFrame frame, int channels, std::shared_ptr<const NodeSource> source,
           bool may_have_gaps = true);
  /// The same value at every position: no nodes, no border. Its frame is one repeated metre.
  static NodeGrid uniform(float value);

  const GridFrame& frame() const { return frame_; }
  int channels() const { return channels_; }
  bool is_uniform() const { return uniform_; }
  bool in_memory() const { return source_ == nullptr; }
  /// Nodes in memory, rows from south; empty where uniform or cached. Asking for them writable ends the
  /// shortcut by which `has_data` knows that no node is NaN: keep a const grid where nothing is painted.
  std::span<const float> values() const { return values_; }
  std::span<float> values() {
    may_have_gaps_ = true;
    return values_;
  }
  /// False only if every node is known to have data.
  bool may_have_gaps() const { return may_have_gaps_; }

  /// Writes `rect`'s nodes, channels interleaved. Beyond the border: the nearest node's value, or the
  /// repeated one.
  void read_block(const NodeRect& rect, std::span<float> out) const;

  /// Bilinear value of `channel` at a position; NaN beyond the border (by more than 1e-6 of the spacing) and
  /// where a contributing node has no data.
  float sample(glm::dvec2 position_m, int channel = 0) const;

  /// Whether every node that bilinear interpolation needs inside [min, max] has data and the box lies inside
  /// the grid (to 1e-6 of the spacing). Always true for a uniform grid.
  bool has_data(glm::dvec2 min_m, glm::dvec2 max_m) const;

 private:
  /// Copies `rect` out of the nodes of `have`, which hold every node that `rect` leads to.
  void copy_block(std::span<const float> nodes, const NodeRect& have, const NodeRect& rect,
                  std::span<float> out) const;

  GridFrame frame_;
  int channels_ = 1;
  bool uniform_ = false;
  bool may_have_gaps_ = false;
  float uniform_value_ = 0.0f;
  std::vector<float> values_;
  std::shared_ptr<const NodeSource> source_;
};

}  // namespace prairie
