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
  GlTexture texture = make_texture(GL_TEXTURE_2D);
  glTextureStorage2D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_R8, kSide, kSide);
  glTextureSubImage2D(texture.get(), 0, 0, 0, kSide, kSide, GL_RED, GL_UNSIGNED_BYTE, texels.data());
  glGenerateTextureMipmap(texture.get());
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace prairie
