#include "render/light/noise_texture.h"

#include <bit>
#include <cstdint>
#include <vector>

#include "shaders/kernels/kernels.h"

namespace prairie {

GlTexture make_noise_texture() {
  constexpr int kSide = layouts::kNoiseSide;
  Kernels kernels;
  std::vector<std::uint8_t> texels;
  for (std::uint32_t n = 0; n < kSide * kSide; ++n)
    texels.push_back(static_cast<std::uint8_t>(kernels.hash_u32(n + 1) >> 24));
  GlTexture texture = make_texture(GL_TEXTURE_2D, "noise");
  glTextureStorage2D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_R8, kSide, kSide);
  glTextureSubImage2D(texture.get(), 0, 0, 0, kSide, kSide, GL_RED, GL_UNSIGNED_BYTE, texels.data());
  glGenerateTextureMipmap(texture.get());
  set_sampling(texture, {.minified = GL_LINEAR_MIPMAP_NEAREST, .magnified = GL_LINEAR, .wrap = GL_REPEAT});
  return texture;
}

}  // namespace prairie
