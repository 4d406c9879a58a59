// Pictures come back from files as they were written.
#include "pictures/picture_input.h"

#include <gtest/gtest.h>

#include <fstream>

#include "files/error.h"
#include "pictures/picture_encoding.h"
#include "tests/temporary_folder.h"

namespace prairie {
namespace {

class PictureInputTest : public testing::Test {
 protected:
  std::filesystem::path written(const char* name, const std::vector<std::byte>& bytes) {
    const std::filesystem::path path = folder_ / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(PictureInputTest, PngHasItsBytesAndTheirLight) {
  std::vector<std::uint8_t> rgb;
  for (int n = 0; n < 3 * 37 * 5; ++n) rgb.push_back(static_cast<std::uint8_t>(n));
  const Picture picture = read_picture(written("a.png", encode_png_rgb8(37, 5, rgb)), "picture");
  EXPECT_EQ(picture.width, 37);
  EXPECT_EQ(picture.height, 5);
  EXPECT_EQ(picture.srgb, rgb);
  EXPECT_FLOAT_EQ(picture.linear_rgb[0], 0.0f);
  EXPECT_FLOAT_EQ(picture.linear_rgb[255], 1.0f);
  EXPECT_NEAR(picture.linear_rgb[128], 0.2158605f, 1e-6f);
}

TEST_F(PictureInputTest, ExrHasItsLight) {
  std::vector<float> rgb;
  for (int n = 0; n < 3 * 8 * 6; ++n) rgb.push_back(0.1f * static_cast<float>(n));
  const Picture picture = read_picture(written("a.exr", encode_exr_rgb(8, 6, rgb)), "picture");
  EXPECT_EQ(picture.linear_rgb, rgb);
  EXPECT_TRUE(picture.srgb.empty());
}

TEST_F(PictureInputTest, RefusesGreyAndWhatIsNoPicture) {
  const std::vector<std::uint8_t> grey(12, 7);
  EXPECT_THROW(read_picture(written("grey.png", encode_png_grey8(4, 3, grey)), "picture"), BadInput);
  EXPECT_THROW(read_picture(written("no.png", std::vector<std::byte>(100)), "picture"), BadInput);
  EXPECT_THROW(read_picture(folder_ / "missing.png", "picture"), BadInput);
}

}  // namespace
}  // namespace prairie
