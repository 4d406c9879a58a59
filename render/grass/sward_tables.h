// A field's look from afar (lod/sward/sward_response.h) where shaders find it: shaders/lib/sward_look.glsl.
#pragma once

#include <span>

#include "generator/meadow.h"
#include "lod/sward/field_look.h"
#include "render/gl/gl_objects.h"
#include "shaders/shared/layouts.h"

namespace prairie {

class SwardTables {
 public:
  SwardTables(const Meadow& meadow, const LightParams& light);

  /// For all that is drawn or computed from now on.
  void bind() const;

  const FieldLook& field() const { return field_; }
  /// The species with what the renderer finds.
  std::span<const SpeciesParams> species() const { return mix_.species; }

 private:
  FieldMix mix_;
  FieldLook field_;
  GlTexture free_;
  GlTexture shaded_;
};

}  // namespace prairie
