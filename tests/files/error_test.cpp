#include "files/error.h"

#include <gtest/gtest.h>

#include <string>

namespace prairie {
namespace {

TEST(Fault, NamesFileFieldFindingAndExpectation) {
  const BadInput fault("ground.tif", "heights.file", "degrees", "metres");
  EXPECT_STREQ(fault.what(), "ground.tif: heights.file: found degrees, expected metres");
  EXPECT_EQ(fault.file, "ground.tif");
  EXPECT_EQ(fault.field, "heights.file");
  EXPECT_EQ(fault.found, "degrees");
  EXPECT_EQ(fault.expected, "metres");
}

TEST(Fault, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(OutputFailure("out.png", "", "no space", "").what(), "out.png: found no space");
  EXPECT_STREQ(OverBudget("", "max-memory", "", "more").what(), "max-memory: expected more");
}

TEST(Fault, IsOneLineWhateverTheFileIsCalled) {
  const std::string line = BadInput("a\nb", "", "c\r\td", "e").what();
  EXPECT_EQ(line, "a b: found c  d, expected e");
}

}  // namespace
}  // namespace prairie
