#include "files/byte_message.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace prairie {
namespace {

TEST(ByteMessage, GivesBackWhatWasPut) {
  MessageWriter writer;
  writer.put(std::int32_t{-3}).put(0.1).put(std::string_view("a\0b", 3));
  writer.put(std::vector<std::string>{"x", "", "yz"}).put(std::optional<double>()).put(std::optional(-0.0));
  writer.put(std::optional<std::string>("text"));
  const std::array<float, 2> values{1.5f, std::numeric_limits<float>::quiet_NaN()};
  writer.put(std::span<const float>(values));
  MessageReader reader(writer.bytes());
  EXPECT_EQ(reader.number<std::int32_t>(), -3);
  EXPECT_EQ(reader.number<double>(), 0.1);
  EXPECT_EQ(reader.text(), std::string("a\0b", 3));
  EXPECT_EQ(reader.texts(), (std::vector<std::string>{"x", "", "yz"}));
  EXPECT_FALSE(reader.optional_number<double>());
  EXPECT_TRUE(std::signbit(*reader.optional_number<double>()));
  EXPECT_EQ(reader.optional_text(), "text");
  const std::vector<float> read = reader.floats();
  EXPECT_EQ(read[0], 1.5f);
  EXPECT_TRUE(std::isnan(read[1]));
  EXPECT_TRUE(reader.rest().empty());
}

TEST(ByteMessage, RefusesWhatBreaksOff) {
  MessageWriter writer;
  writer.put(std::vector<std::string>{"abc", "defgh"}).put(std::span<const float>(std::array{1.0f, 2.0f}));
  for (std::size_t length = 0; length < writer.bytes().size(); ++length) {
    MessageReader reader(writer.bytes().first(length));
    EXPECT_THROW(
        {
          reader.texts();
          reader.floats();
        },
        BrokenMessage)
        << length;
  }
  MessageWriter claim;
  claim.put(~std::uint64_t{0});
  EXPECT_THROW(MessageReader(claim.bytes()).texts(), BrokenMessage);
  EXPECT_THROW(MessageReader(claim.bytes()).floats(), BrokenMessage);
}

}  // namespace
}  // namespace prairie
