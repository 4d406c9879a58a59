// `prairie plant`: tables that hold every blade once and in order, and hashes that do not depend on the
// threads.
#include "generator/plant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/outputs/blade_table.h"
#include "app/scenes/open_world.h"
#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::Outcome;

class Plant : public ::testing::Test {
 protected:
  Plant() { testing::write_small_scene(folder_ / "scene"); }

  std::string text_of(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::uint64_t planted_blades() const {
    const World world = open_world(scene_, {});
    std::uint64_t blades = 0;
    for (int j = 0; j < testing::kSmallSceneTiles; ++j) {
      for (int i = 0; i < testing::kSmallSceneTiles; ++i) blades += planted_count(world.meadow(), {i, j});
    }
    return blades;
  }

  const TemporaryFolder folder_;
  const std::string scene_ = (folder_ / "scene").string();
};

TEST_F(Plant, HashesAreOrderedByRowsFromTheSouth) {
  const Outcome outcome = testing::prairie({"plant", scene_, "--hashes", "-o", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  for (int j = 0; j < testing::kSmallSceneTiles; ++j) {
    for (int i = 0; i < testing::kSmallSceneTiles; ++i) {
      int line_i = -1;
      int line_j = -1;
      std::string hash;
      lines >> line_i >> line_j >> hash;
      EXPECT_EQ(line_i, i);
      EXPECT_EQ(line_j, j);
      EXPECT_EQ(hash.size(), 16u);
      EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
    }
  }
  std::string rest;
  lines >> rest;
  EXPECT_EQ(rest, "");
}

TEST_F(Plant, DoesNotDependOnTheNumberOfThreads) {
  for (const std::string kind : {"csv", "ply", "hashes"}) {
    std::vector<std::string> outputs;
    for (const std::string threads : {"1", "2", "7"}) {
      const std::string name = threads + "." + kind;
      std::vector<std::string> arguments{"plant",     scene_, "-o", (folder_ / name).string(),
                                         "--threads", threads};
      if (kind == "hashes") arguments.emplace_back("--hashes");
      const Outcome outcome = testing::prairie(arguments);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      outputs.push_back(text_of(name));
    }
    EXPECT_FALSE(outputs[0].empty());
    EXPECT_TRUE(outputs[0] == outputs[1] && outputs[1] == outputs[2]) << kind;
  }
}

TEST_F(Plant, CsvHasARowForEveryBlade) {
  const Outcome outcome = testing::prairie({"plant", scene_, "-o", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto lines = static_cast<std::uint64_t>(std::ranges::count(outcome.out, '\n'));
  EXPECT_EQ(lines, planted_blades() + 1);
  const std::string header = outcome.out.substr(0, outcome.out.find('\n'));
  EXPECT_TRUE(header.starts_with("tile_i,tile_j,species,cell,index,x_m,y_m,z_m,height_m")) << header;
  const auto columns = std::ranges::count(header, ',');
  std::istringstream rows(outcome.out);
  for (std::string row; std::getline(rows, row);) ASSERT_EQ(std::ranges::count(row, ','), columns) << row;
}

TEST_F(Plant, PlyStatesItsVerticesAndHasThem) {
  ASSERT_EQ(testing::prairie({"plant", scene_, "-o", (folder_ / "a.ply").string()}).exit_code, 0);
  const std::string ply = text_of("a.ply");
  const std::string end = "end_header\n";
  const std::string header = ply.substr(0, ply.find(end) + end.size());
  std::size_t bytes_per_vertex = 0;
  std::uint64_t vertices = 0;
  std::istringstream lines(header);
  for (std::string word; lines >> word;) {
    if (word == "vertex") lines >> vertices;
    if (word == "double") bytes_per_vertex += 8;
    if (word == "float" || word == "int" || word == "uint") bytes_per_vertex += 4;
    if (word == "uchar") bytes_per_vertex += 1;
  }
  EXPECT_EQ(vertices, planted_blades());
  EXPECT_EQ(ply.size(), header.size() + vertices * bytes_per_vertex);
}

TEST_F(Plant, ChosenTilesAreThoseOfTheWhole) {
  const std::string all = testing::prairie({"plant", scene_, "--hashes", "-o", "-"}).out;
  const std::string some =
      testing::prairie({"plant", scene_, "--hashes", "-o", "-", "--tiles", "2,1,1,2"}).out;
  EXPECT_EQ(std::ranges::count(some, '\n'), 4);
  std::istringstream lines(some);
  for (std::string line; std::getline(lines, line);)
    EXPECT_NE(all.find(line + "\n"), std::string::npos) << line;
}

TEST_F(Plant, MemoryDoesNotGrowWithTheTiles) {
  const std::vector<std::string> larger{"--set", "height.spacing_m=8.0", "--set",
                                        "species.0.density.spacing_m=8.0"};
  std::vector<std::string> arguments{"plant", scene_, "-o", (folder_ / "a.csv").string()};
  const Outcome small = testing::prairie(arguments);
  arguments.insert(arguments.end(), larger.begin(), larger.end());
  const Outcome large = testing::prairie(arguments);
  ASSERT_EQ(large.exit_code, 0) << large.err;
  EXPECT_GT(std::filesystem::file_size(folder_ / "a.csv"), 128u << 20);
  EXPECT_LT(large.largest_memory_mib, small.largest_memory_mib + 64);
}

}  // namespace
}  // namespace prairie
