#include "maps/node_store.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "files/spool_file.h"

namespace prairie {
namespace {

std::uint64_t value_offset(const GridFrame& frame, int channels, int column, int row) {
  return (static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(frame.columns) +
          static_cast<std::uint64_t>(column)) *
         static_cast<std::uint64_t>(channels);
}

class SpooledNodes : public NodeSource {
 public:
  SpooledNodes(std::shared_ptr<const SpoolFile> file, const GridFrame& frame, int channels)
      : file_(std::move(file)), frame_(frame), channels_(channels) {}

  void read(const NodeRect& rect, std::span<float> out) const override {
    const std::size_t row_values =
        static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(channels_);
    for (int row = 0; row < rect.rows; ++row) {
      file_->read(
          sizeof(float) * value_offset(frame_, channels_, rect.column, rect.row + row),
          std::as_writable_bytes(out.subspan(static_cast<std::size_t>(row) * row_values, row_values)));
    }
  }

 private:
  std::shared_ptr<const SpoolFile> file_;
  GridFrame frame_;
  int channels_;
};

}  // namespace

NodeStore::NodeStore(std::uint64_t budget_bytes) : budget_bytes_(budget_bytes) {}
NodeStore::~NodeStore() = default;

void NodeStore::begin(const GridFrame& frame, int channels) {
  frame_ = frame;
  channels_ = channels;
  const std::uint64_t count = value_offset(frame, channels, 0, frame.rows);
  if (count * sizeof(float) <= budget_bytes_) {
    values_.resize(count);
  } else {
    spool_ = std::make_shared<SpoolFile>();
  }
}

void NodeStore::take(const NodeRect& rect, std::span<const float> values) {
  assert(rect.column >= 0 && rect.row >= 0 && rect.column + rect.columns <= frame_.columns &&
         rect.row + rect.rows <= frame_.rows);
  const std::size_t row_values = static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(channels_);
  for (int row = 0; row < rect.rows; ++row) {
    const std::span<const float> line =
        values.subspan(static_cast<std::size_t>(row) * row_values, row_values);
    const std::uint64_t at = value_offset(frame_, channels_, rect.column, rect.row + row);
    if (spool_ == nullptr) {
      std::ranges::copy(line, values_.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      spool_->write(sizeof(float) * at, std::as_bytes(line));
    }
  }
}

NodeGrid NodeStore::release(bool has_gaps) {
  if (spool_ == nullptr) return NodeGrid(frame_, channels_, std::move(values_));
  return NodeGrid(frame_, channels_, std::make_shared<SpooledNodes>(std::move(spool_), frame_, channels_),
                  has_gaps);
}

}  // namespace prairie
