// The passes that a world is drawn with, in their order.
#pragma once

#include <filesystem>
#include <vector>

#include "render/frame/frame_blocks.h"
#include "render/frame/pass.h"
#include "render/gl/gl_objects.h"
#include "render/grass/blade_pass.h"
#include "render/grass/ground_pass.h"
#include "render/grass/moving_fields.h"
#include "render/grass/strip_pass.h"
#include "render/grass/sward_tables.h"
#include "render/light/sky_pass.h"
#include "render/overlays/field_overlay_pass.h"
#include "render/overlays/line_pass.h"
#include "render/things/obstacle_pass.h"
#include "render/things/solid_pass.h"
#include "render/things/walker_pass.h"

namespace prairie {

struct ScenePasses {
  /// Compiles shaders and paints the textures that depend on the scene alone. Throws NoSuitableOpenGl,
  /// BadInput.
  ScenePasses(const World& world, const std::filesystem::path& shader_folder, StreamBuffer& stream);

  /// Everything but the frame's blocks that all passes read.
  void bind_shared() const;

  LightParams light;
  GlTexture noise;
  SwardTables sward;
  GroundPass ground;
  FieldParams field;
  BladePass blades;
  StripPass strips;
  ObstaclePass obstacles;
  SolidPass solids;
  WalkerPass walkers;
  SkyPass sky;
  FieldOverlayPass field_overlay;
  LinePass lines;
  MovingFields moving_fields;
};

/// Blades first: they hide most of the ground, whose fragments cost more.
std::vector<Pass> passes_of(ScenePasses& scene);

}  // namespace prairie
