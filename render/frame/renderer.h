// Draws a world: takes a camera, has lod/ plan the frame, has compute shaders grow the plan's blades (one
// dispatch for each kind of mesh) and lay its strips, draws blades, strips, ground and sky into a linear HDR
// target, and hands out pictures. Needs a current OpenGL 4.5 core context, from a window or a
// HeadlessContext, that outlives it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "agents/obstacle.h"
#include "lod/camera.h"
#include "lod/frame_plan.h"
#include "lod/quality.h"
#include "render/gl/stage_time.h"
#include "render/overlays/field_overlay.h"
#include "render/overlays/line_segment.h"
#include "render/things/walker_look.h"
#include "world/world.h"

namespace prairie {

/// What one tier of a frame draws.
struct TierStatistics {
  std::uint64_t blades = 0;  // of strips and the flat tier: those they stand for
  std::uint64_t triangles = 0;
};

struct FrameStatistics {
  std::uint64_t blades_planted_in_view = 0;  // of the cells that the plan holds, before thinning
  std::uint64_t blades_drawn = 0;            // as 3D blades
  std::uint64_t triangles = 0;
  TierStatistics spline, hermite, strip, flat;
  double plan_ms = 0.0;
  std::vector<StageTime> gpu_times;  // of a frame some frames ago
};

struct FrameOptions {
  Tier tier = Tier::kAuto;
  bool msaa = false;  // 4 samples per pixel
  std::uint64_t memory_budget_bytes =
      std::numeric_limits<std::uint64_t>::max();  // for the plan (lod/planner.h)
  std::optional<Quality> quality = {};            // the scene's, if not given
  std::optional<glm::dvec3> lod_eye_m = {};       // tiers are chosen for this eye; the camera's, if not given
  bool tier_tint = false;  // colours each tier: spline red, Hermite yellow, strips green, flat blue
  FieldOverlay field_overlay = FieldOverlay::kNone;
  std::span<const WalkerLook> walkers = {};  // drawn besides the world's; not owned
  std::span<const LineSegment> lines = {};   // drawn over the picture; not owned
};

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> linear_rgb;   // rows from the top
  std::vector<std::uint8_t> srgb;  // the same, exposed, tone-mapped, sRGB-encoded
  std::vector<float> cover;        // share of each pixel that shows grass
  FrameStatistics statistics;
};

class Renderer {
 public:
  /// `shader_folder`: where shaders/ was installed (see app/scenes/installed_files.h). Throws
  /// NoSuitableOpenGl, BadInput.
  Renderer(const World& world, const std::filesystem::path& shader_folder);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// What stands in the meadow from now on. Throws NoSuitableOpenGl, BadInput
  /// (render/things/obstacle_pass.h).
  void stand(const StandingThings& things);

  /// What is done while a frame is drawn: once all that time moves has been read, it runs beside the drawing
  /// in a thread of its own (afterwards, where oneTBB may use only one) and has ended when the drawing
  /// returns. It may step the world for the next frame, not touch OpenGL. What it throws is passed on.
  using Meanwhile = std::function<void()>;

  /// Draws one frame into the framebuffer `target` (0: the window), tone-mapped. The camera's size is the
  /// target's.
  FrameStatistics draw(const Camera& camera, const FrameOptions& options, unsigned target,
                       const Meanwhile& meanwhile = {});

  /// Draws `samples` jittered frames, averages them in linear light and reads the picture back.
  Picture render(const Camera& camera, const FrameOptions& options, int samples,
                 const Meanwhile& meanwhile = {});

 private:
  struct Passes;
  std::unique_ptr<Passes> passes_;
};

}  // namespace prairie
