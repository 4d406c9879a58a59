#include "app/terminal/option_values.h"

#include <gtest/gtest.h>

#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

TEST(OptionValues, Bytes) {
  EXPECT_EQ(bytes_option("--m", "1000"), 1000u);
  EXPECT_EQ(bytes_option("--m", "2K"), 2048u);
  EXPECT_EQ(bytes_option("--m", "512M"), 512ull << 20);
  EXPECT_EQ(bytes_option("--m", "1.5GiB"), 3ull << 29);
  EXPECT_EQ(bytes_option("--m", "1tb"), 1ull << 40);
  EXPECT_THROW(bytes_option("--m", "5 M"), UsageError);
  EXPECT_THROW(bytes_option("--m", "5MM"), UsageError);
}

TEST(OptionValues, Seed) {
  EXPECT_EQ(seed_option("--seed", "18446744073709551615"), ~std::uint64_t{0});
  EXPECT_EQ(seed_option("--seed", "0xff"), 255u);
  EXPECT_THROW(seed_option("--seed", "0x"), UsageError);
  EXPECT_THROW(seed_option("--seed", "+1"), UsageError);
}

TEST(OptionValues, Size) {
  EXPECT_EQ(size_option("--size", "1x16384"), glm::ivec2(1, kMaxPictureSidePx));
  EXPECT_EQ(size_option("--size", "800x600"), glm::ivec2(800, 600));
}

TEST(OptionValues, TilesInEitherOrder) {
  const TileRange tiles = tiles_option("--tiles", "5,-2,3,4");
  EXPECT_EQ(tiles.first, (TileId{3, -2}));
  EXPECT_EQ(tiles.last, (TileId{5, 4}));
}

TEST(OptionValues, TiersHaveNames) {
  for (const Tier tier : {Tier::kAuto, Tier::kSpline, Tier::kHermite, Tier::kStrip, Tier::kFlat}) {
    EXPECT_EQ(tier_option("--tier", tier_name(tier)), tier);
  }
}

TEST(OptionValues, ErrorsAreOneLineThatNamesTheOption) {
  try {
    choice_option("--tier", "flt", {"auto", "flat"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--tier: found flt (did you mean flat?), expected one of auto, flat");
  }
}

TEST(OptionValuesTest, PlacesAreThreeNumbers) {
  EXPECT_EQ(place_option("--lod-eye", "1,-2.5,+3"), glm::dvec3(1.0, -2.5, 3.0));
  for (const char* text : {"", "1,2", "1,2,3,4", "1,2,up", "1,2,nan"}) {
    EXPECT_THROW(place_option("--lod-eye", text), UsageError) << text;
  }
}

}  // namespace
}  // namespace prairie
