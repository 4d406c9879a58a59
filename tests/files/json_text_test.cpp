#include "files/json_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace prairie {
namespace {

TEST(JsonText, KeepsTheOrderOfMembers) {
  const JsonObject json{
      {"z", 1}, {"a", JsonArray{-2, 18446744073709551615u, 0.5f, 1.0}}, {"m", JsonObject{}}};
  EXPECT_EQ(json_text(json),
            "{\n  \"z\": 1,\n  \"a\": [\n    -2,\n    18446744073709551615,\n    0.5,\n    1.0\n  ],\n"
            "  \"m\": {}\n}");
}

TEST(JsonText, KnowsTruthTextAndNothing) {
  EXPECT_EQ(json_text(JsonArray{}), "[]");
  EXPECT_EQ(json_text({}), "null");
  EXPECT_EQ(json_text(true), "true");
  EXPECT_EQ(json_text("a \"b\"\n"), R"("a \"b\"\n")");
  EXPECT_EQ(json_text(json_array(std::vector<std::string>{"a"})), "[\n  \"a\"\n]");
}

TEST(JsonText, NumbersReadBackAsTheyWere) {
  EXPECT_EQ(json_text(0.1), "0.1");
  EXPECT_EQ(json_text(0.30000000000000004), "0.30000000000000004");
  EXPECT_EQ(json_text(1e300), "1e+300");
  EXPECT_EQ(json_text(1.0), "1.0");
  EXPECT_EQ(json_text(-0.0), "-0.0");
  EXPECT_EQ(json_text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(JsonText, ReplacesWhatJsonCannotSay) {
  EXPECT_EQ(json_text("a\xff"), "\"a\xef\xbf\xbd\"");
  EXPECT_EQ(json_text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(json_text(std::numeric_limits<double>::quiet_NaN()), "null");
}

}  // namespace
}  // namespace prairie
