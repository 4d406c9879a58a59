// A picture is developed twice: by a shader for the window, on the CPU for files. Both make the same of it.
#include "render/post/develop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/post/developed_picture.h"
#include "tests/render/headless_test.h"

namespace prairie {
namespace {

constexpr glm::ivec2 kSizePx{64, 16};
constexpr float kExposure = 0.78f;

/// From black to far brighter than white, each channel in its own way, rows from the bottom.
std::vector<float> ramp() {
  std::vector<float> rgba;
  for (int n = 0; n < kSizePx.x * kSizePx.y; ++n) {
    const float t = static_cast<float>(n) / static_cast<float>(kSizePx.x * kSizePx.y - 1);
    rgba.insert(rgba.end(), {4.0f * t * t, 0.5f * t, 1.0f - t, t});
  }
  return rgba;
}

TEST(DevelopedPictureTest, IsRightWayUpAndRisesWithTheLight) {
  const Picture picture = developed_picture(kSizePx, ramp(), kExposure);
  ASSERT_EQ(picture.srgb.size(), std::size_t{3} * 64 * 16);
  // The ramp's first row is the picture's last.
  EXPECT_EQ(picture.linear_rgb[3 * 15 * 64 + 2], 1.0f);
  EXPECT_EQ(picture.srgb[3 * 15 * 64], 0);
  EXPECT_EQ(picture.cover.back(), ramp()[4 * 63 + 3]);
  for (std::size_t column = 1; column < 64; ++column) {
    EXPECT_GE(picture.srgb[3 * column], picture.srgb[3 * (column - 1)]);
    EXPECT_LE(picture.srgb[3 * column + 2], picture.srgb[3 * (column - 1) + 2]);
  }
}

class DevelopTest : public HeadlessTest {};

TEST_F(DevelopTest, ShaderAndCpuAgreeToAStep) {
  const std::vector<float> rgba = ramp();
  const GlTexture linear = make_texture(GL_TEXTURE_2D, "linear picture");
  glTextureStorage2D(linear.get(), 1, GL_RGBA32F, kSizePx.x, kSizePx.y);
  glTextureSubImage2D(linear.get(), 0, 0, 0, kSizePx.x, kSizePx.y, GL_RGBA, GL_FLOAT, rgba.data());
  const GlTexture shown = make_texture(GL_TEXTURE_2D, "shown picture");
  glTextureStorage2D(shown.get(), 1, GL_RGBA8, kSizePx.x, kSizePx.y);
  const GlFramebuffer framebuffer = make_framebuffer("shown picture");
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT0, shown.get(), 0);

  Develop(PRAIRIE_TEST_SHADERS).draw(linear.get(), framebuffer.get(), kSizePx, kExposure);

  std::vector<std::uint8_t> pixels(rgba.size());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.get());
  glReadPixels(0, 0, kSizePx.x, kSizePx.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const Picture picture = developed_picture(kSizePx, rgba, kExposure);
  for (int row = 0; row < kSizePx.y; ++row) {
    for (int value = 0; value < 3 * kSizePx.x; ++value) {
      const int pixel = (kSizePx.y - 1 - row) * kSizePx.x + value / 3;
      const int on_gpu = pixels[static_cast<std::size_t>(4 * pixel + value % 3)];
      const int on_cpu = picture.srgb[static_cast<std::size_t>(3 * kSizePx.x * row + value)];
      EXPECT_LE(std::abs(on_gpu - on_cpu), 1) << row << ", " << value;
    }
  }
}

}  // namespace
}  // namespace prairie
