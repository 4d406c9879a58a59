// Cells too large for one storage buffer are drawn in pieces that follow one another without gap or overlap.
#include "render/grass/compute_batch.h"

#include <gtest/gtest.h>

namespace prairie {
namespace {

TEST(ComputeBatchTest, PiecesHoldEveryBladeOnce) {
  std::vector<DrawnCell> cells(3);
  cells[0].drawn = 10;
  cells[1].drawn = 4'480'000;
  cells[2].drawn = 7;
  const std::size_t most = most_blades(15 * sizeof(GrownVertex));
  EXPECT_LE(most * 15 * sizeof(GrownVertex), kStorageLimitBytes);
  const std::vector<DrawnCell> pieces = pieces_of(cells, most);
  std::uint64_t blades = 0;
  std::uint32_t next = 0;
  for (const DrawnCell& piece : pieces) {
    EXPECT_LE(piece.drawn, most);
    if (piece.first_index == 0) next = 0;
    EXPECT_EQ(piece.first_index, next);
    next += piece.drawn;
    blades += piece.drawn;
  }
  EXPECT_EQ(blades, 4'480'017u);
  for (const CellRun& run : runs_of(pieces, most)) EXPECT_LE(run.blades, most);
}

}  // namespace
}  // namespace prairie
