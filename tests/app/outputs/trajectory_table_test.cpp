#include "app/outputs/trajectory_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "agents/track_files.h"
#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

TEST(TrajectoryTable, HasALineForEachWalkerAsManyCellsAsItsHeader) {
  const std::string text =
      std::string(testing::kPlainScene) + "[[walkers]]\nname = \"pair\"\nstarts_m = [[5, 5], [20, 10]]\n";
  World world(parse_scene(text, "folder", {}), {});
  const std::string header = trajectory_header();
  std::string rows = trajectory_rows(world);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 2);
  EXPECT_EQ(std::ranges::count(rows, ','), 2 * std::ranges::count(header, ','));
  world.step(0.5);
  rows += trajectory_rows(world);

  const std::vector<Track> tracks = parse_tracks(header + rows, "table").tracks;
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].times_s.size(), 2u);
}

}  // namespace
}  // namespace prairie
