// Pictures that are stored turned or mirrored: where their pixels belong (TIFF 6.0, tag 274; EXIF says the
// same).
#pragma once

#include <span>
#include <vector>

#include "pictures/pixel_rect.h"

namespace prairie {

/// How the first row and column of a stored picture lie in the upright one: 1 top, left (as it is) … 8 left,
/// bottom. Other numbers count as 1.
struct Orientation {
  int code = 1;
  int stored_columns = 0;
  int stored_rows = 0;

  bool is_upright() const { return code <= 1 || code > 8; }
  /// Whether stored rows become columns.
  bool is_transposed() const { return code >= 5 && code <= 8; }
  int columns() const { return is_transposed() ? stored_rows : stored_columns; }
  int rows() const { return is_transposed() ? stored_columns : stored_rows; }
};

/// Where a stored rectangle lies in the upright picture.
PixelRect upright_rect(const Orientation& orientation, const PixelRect& stored);

/// The samples of a stored rectangle (rows from its top, `channels` interleaved) in the order of its upright
/// one.
std::vector<float> upright_samples(const Orientation& orientation, const PixelRect& stored,
                                   std::span<const float> samples, int channels);

}  // namespace prairie
