#include "files/joined.h"

#include <gtest/gtest.h>

#include <vector>

namespace prairie {
namespace {

TEST(Joined, PutsItBetweenAlone) {
  EXPECT_EQ(joined({}, ", "), "");
  EXPECT_EQ(joined(std::vector<std::string>{"a"}, ", "), "a");
  EXPECT_EQ(joined(std::vector<std::string>{"", "a", ""}, "/"), "/a/");
}

}  // namespace
}  // namespace prairie
