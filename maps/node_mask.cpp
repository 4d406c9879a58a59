#include "maps/node_mask.h"

#include <cassert>
#include <cmath>

namespace prairie {

NodeMask::NodeMask(int columns, int rows, std::span<const float> values)
    : words_per_row_((static_cast<std::size_t>(columns) + 63) / 64),
      words_(words_per_row_ * static_cast<std::size_t>(rows)) {
  assert(values.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::size_t node = 0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j) {
    std::uint64_t* row = words_.data() + j * words_per_row_;
    for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i, ++node) {
      row[i / 64] |= static_cast<std::uint64_t>(std::isnan(values[node])) << (i % 64);
    }
  }
}

bool NodeMask::any(const NodeRect& rect) const {
  if (rect.columns <= 0 || rect.rows <= 0) return false;
  const std::size_t first = static_cast<std::size_t>(rect.column);
  const std::size_t last = first + static_cast<std::size_t>(rect.columns) - 1;
  const std::uint64_t first_bits = ~std::uint64_t{0} << (first % 64);
  const std::uint64_t last_bits = ~std::uint64_t{0} >> (63 - last % 64);
  for (int j = 0; j < rect.rows; ++j) {
    const std::uint64_t* row = words_.data() + static_cast<std::size_t>(rect.row + j) * words_per_row_;
    for (std::size_t word = first / 64; word <= last / 64; ++word) {
      std::uint64_t bits = row[word];
      if (word == first / 64) bits &= first_bits;
      if (word == last / 64) bits &= last_bits;
      if (bits != 0) return true;
    }
  }
  return false;
}

}  // namespace prairie
