// A rectangle of a picture.
#pragma once

namespace prairie {

/// In pixels from the top left.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

}  // namespace prairie
