#include "world/suspicions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "world/world.h"

namespace prairie {
namespace {

constexpr const char* kField =
    "version = 1\n[ground]\nsize_m = [60, 40]\n[[species]]\nname = \"a\"\ndensity = 1\n";

/// Codes of what is suspicious in the field with these sections.
std::vector<std::string> codes(const std::string& sections) {
  const World world(parse_scene(kField + sections, ".", {}), {});
  std::vector<std::string> found;
  for (const Warning& warning : world.warnings()) {
    EXPECT_FALSE(warning.text.empty());
    found.push_back(warning.code);
  }
  return found;
}

using Codes = std::vector<std::string>;

TEST(Suspicions, GoalsAndStartsBesideTheGround) {
  const std::string walkers =
      "[[walkers]]\nname = \"w\"\ncount = 1\nbehaviour = \"visit\"\ngoals = [\"g\"]\nradius_m = 1\n";
  EXPECT_EQ(codes("[[goal]]\nname = \"g\"\nposition_m = [30, 20]\n" + walkers + "position_m = [10, 10]\n"),
            Codes());
  EXPECT_EQ(codes("[[goal]]\nname = \"g\"\nposition_m = [61, 20]\nradius_m = 2\n" + walkers +
                  "position_m = [10, 10]\n"),
            Codes())
      << "its rim lies on the ground";
  EXPECT_EQ(codes("[[goal]]\nname = \"g\"\nposition_m = [90, 20]\n" + walkers + "position_m = [10, 10]\n"),
            Codes{"beside-ground"});
  EXPECT_EQ(codes("[[goal]]\nname = \"g\"\nposition_m = [30, 20]\n" + walkers + "position_m = [-70, 10]\n"),
            Codes{"beside-ground"});
}

TEST(Suspicions, GoalsInsideOfSomething) {
  const std::string block = "[[obstacle]]\nkind = \"box\"\nposition_m = [30, 20]\nsize_m = [6, 6, 2]\n";
  EXPECT_EQ(codes(block + "[[goal]]\nname = \"g\"\nposition_m = [30, 20]\n"), Codes{"inside-something"});
  EXPECT_EQ(codes(block + "[[goal]]\nname = \"g\"\nposition_m = [30, 20]\nradius_m = 4\n"), Codes());
  EXPECT_EQ(codes(block + "[[goal]]\nname = \"g\"\nposition_m = [36, 20]\n"), Codes());
}

TEST(Suspicions, PathsThatNeverComeOntoTheGround) {
  EXPECT_EQ(codes("[[mover]]\nname = \"m\"\npath_m = [[-5, 5], [5, 5]]\n"), Codes());
  EXPECT_EQ(codes("[[mover]]\nname = \"m\"\npath_m = [[5000, 5], [5010, 5]]\n"), Codes{"beside-ground"});
}

TEST(Suspicions, ThereAreNoneInTheExamples) {
  for (const char* name : {"meadow", "frost", "walkers", "windy"}) {
    const World world(read_scene(std::filesystem::path(PRAIRIE_SOURCES) / "examples" / name, {}), {});
    EXPECT_TRUE(world.warnings().empty()) << name << ": " << world.warnings().front().text;
  }
}

}  // namespace
}  // namespace prairie
