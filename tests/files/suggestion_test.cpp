#include "files/suggestion.h"

#include <gtest/gtest.h>

#include <vector>

namespace prairie {
namespace {

const std::vector<std::string> kKnown{"height_spread", "height_m", "width_mm", "tilt_deg", "name"};

TEST(Suggestion, FindsOneWrongLetter) {
  EXPECT_EQ(suggestion("widht_mm", kKnown), "width_mm");
}
TEST(Suggestion, FindsSwappedLetters) {
  EXPECT_EQ(suggestion("heigth_m", kKnown), "height_m");
}
TEST(Suggestion, FindsAMissingUnit) {
  EXPECT_EQ(suggestion("height", kKnown), "height_m");
}
TEST(Suggestion, IgnoresLetterCase) {
  EXPECT_EQ(suggestion("Name", kKnown), "name");
}
TEST(Suggestion, IsSilentAboutStrangers) {
  EXPECT_EQ(suggestion("elephant", kKnown), std::nullopt);
}
TEST(Suggestion, IsSilentAboutNothing) {
  EXPECT_EQ(suggestion("", kKnown), std::nullopt);
}
TEST(Suggestion, IsSilentAboutAVeryLongWord) {
  EXPECT_EQ(suggestion(std::string(100'000, 'a'), kKnown), std::nullopt);
}

}  // namespace
}  // namespace prairie
