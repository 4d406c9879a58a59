#include "maps/world_file.h"

#include <gtest/gtest.h>

#include "files/decimal.h"
#include "files/error.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

TEST(WorldFile, IsSixNumbers) {
  const std::optional<WorldFile> world =
      parse_world_file("0.5\r\n0\n 0.0 \n-0.5\n702000.25\n+4333999.75\n\n");
  ASSERT_TRUE(world.has_value());
  EXPECT_EQ(world->a, 0.5);
  EXPECT_EQ(world->e, -0.5);
  EXPECT_EQ(world->c, 702000.25);
  EXPECT_EQ(world->f, 4333999.75);
}

TEST(WorldFile, AnythingElseIsNone) {
  for (const char* text :
       {"", "1 2 3 4 5", "1 2 3 4 5 6 7", "1 0 0 -1 x 0", "1,0,0,-1,0,0", "1 0 0 -1 0 0x"}) {
    EXPECT_FALSE(parse_world_file(text).has_value()) << text;
  }
}

TEST(WorldFile, IsFoundUnderItsCustomaryNames) {
  for (const char* name : {"map.tfw", "map.tifw", "map.wld", "map.TFW"}) {
    const TemporaryFolder folder;
    EXPECT_FALSE(find_world_file(folder / "map.tif").has_value());
    testing::write_text(folder / name, "1 0 0 -1 0 0");
    EXPECT_EQ(find_world_file(folder / "map.tif"), folder / name);
  }
}

TEST(WorldFile, BrokenIsNamed) {
  const TemporaryFolder folder;
  testing::write_text(folder / "map.wld", std::string(10000, '1'));
  EXPECT_THROW(read_world_file(folder / "map.wld"), BadInput);
}

TEST(Decimal, KnowsWhatOtherProgramsWrite) {
  EXPECT_EQ(parse_decimal("-9999"), -9999.0);
  EXPECT_EQ(parse_decimal(" -3.4028234663852886e+38 "), -3.4028234663852886e+38);
  EXPECT_EQ(parse_decimal("+1.5"), 1.5);
  EXPECT_TRUE(std::isnan(*parse_decimal("nan")));
  EXPECT_TRUE(std::isinf(*parse_decimal("-1e999")));
  EXPECT_EQ(parse_decimal("1e-999"), 0.0);
  EXPECT_EQ(parse_decimal("0.00000"), 0.0);
  for (const char* text : {"", " ", "1,5", "0x10", "--1", "+-1", "1 2", "e5"}) {
    EXPECT_FALSE(parse_decimal(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace prairie
