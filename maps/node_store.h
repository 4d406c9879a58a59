// Keeps the nodes of a map that is being decoded: in memory where they fit, else in a temporary file.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "maps/map_sink.h"

namespace prairie {

class SpoolFile;

class NodeStore : public MapSink {
 public:
  explicit NodeStore(std::uint64_t budget_bytes);
  ~NodeStore() override;

  /// Throws OutputFailure where a temporary file cannot be written.
  void begin(const GridFrame& frame, int channels) override;
  void take(const NodeRect& rect, std::span<const float> values) override;

  /// The nodes, once all have come.
  NodeGrid release(bool has_gaps);

 private:
  std::uint64_t budget_bytes_;
  GridFrame frame_;
  int channels_ = 1;
  std::vector<float> values_;
  std::shared_ptr<SpoolFile> spool_;
};

}  // namespace prairie
