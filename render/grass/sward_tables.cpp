#include "render/grass/sward_tables.h"

namespace prairie {
namespace {

GlTexture upload(const SwardResponse& response, std::vector<glm::vec4> SwardResponse::Colors::*table,
                 const char* label) {
  GlTexture texture = make_texture(GL_TEXTURE_3D, label);
  const int slices = SwardResponse::kDepths * static_cast<int>(1 + response.layers.size());
  glTextureStorage3D(texture.get(), 1, GL_RGBA16F, SwardResponse::kElevations, SwardResponse::kAzimuths,
                     slices);
  const auto put = [&](int slice, const SwardResponse::Colors& colors) {
    glTextureSubImage3D(texture.get(), 0, 0, 0, slice, SwardResponse::kElevations, SwardResponse::kAzimuths,
                        SwardResponse::kDepths, GL_RGBA, GL_FLOAT, (colors.*table).data());
  };
  put(0, response.colors);
  for (std::size_t n = 0; n < response.layers.size(); ++n)
    put(SwardResponse::kDepths * static_cast<int>(n + 1), response.layers[n].colors);
  set_sampling(texture, {.minified = GL_LINEAR, .magnified = GL_LINEAR, .wrap = GL_CLAMP_TO_EDGE});
  return texture;
}

}  // namespace

SwardTables::SwardTables(const Meadow& meadow, const LightParams& light) : mix_(field_mix(meadow)) {
  const SwardResponse response = sward_response(layers_of(mix_), light);
  free_ = upload(response, &SwardResponse::Colors::free, "sward in the sun");
  shaded_ = upload(response, &SwardResponse::Colors::shaded, "sward in its own shade");
  field_ = field_look(mix_, response);
  for (std::size_t s = 0; s < mix_.species.size(); ++s)
    mix_.species[s].blade_area_m2 = static_cast<float>(response.layers[s].blade_area_m2);
}

void SwardTables::bind() const {
  glBindTextureUnit(layouts::kSwardFreeUnit, free_.get());
  glBindTextureUnit(layouts::kSwardShadedUnit, shaded_.get());
}

}  // namespace prairie
