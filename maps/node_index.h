// Node indices beyond a grid's border: the nearest node where the grid ends, the repeated one where it
// repeats.
#pragma once

#include <algorithm>

namespace prairie {

inline int wrapped_index(int index, int count) {
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

inline int border_index(int index, int count, bool repeats) {
  return repeats ? wrapped_index(index, count) : std::clamp(index, 0, count - 1);
}

/// A run of indices along one axis.
struct IndexSpan {
  int first = 0;
  int count = 0;
};

/// The indices inside the grid that `span` leads to; the whole axis where a repeated span crosses the border.
inline IndexSpan inside_span(IndexSpan span, int size, bool repeats) {
  if (!repeats) {
    const int first = std::clamp(span.first, 0, size - 1);
    return {first, std::clamp(span.first + span.count - 1, 0, size - 1) - first + 1};
  }
  const int first = wrapped_index(span.first, size);
  if (span.count > size - first) return {0, size};
  return {first, span.count};
}

}  // namespace prairie
