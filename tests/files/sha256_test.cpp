#include "files/sha256.h"

#include <gtest/gtest.h>

#include <string_view>

namespace prairie {
namespace {

// The example of FIPS 180-2, appendix B.1, and the empty message.
TEST(Sha256, PublishedExamples) {
  constexpr std::string_view kMessage = "abc";
  EXPECT_EQ(sha256_hex(std::as_bytes(std::span(kMessage))),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace prairie
