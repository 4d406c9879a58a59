// Draws a world: takes cameras, has lod/ plan what each sees, and runs an ordered list of passes for each
// view: grow the plan's blades and lay its strips in compute shaders, draw blades, strips, things, ground and
// sky into a linear HDR target, develop it. Needs a current OpenGL 4.5 core context, from a window or a
// HeadlessContext, that outlives it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lod/camera.h"
#include "pictures/picture.h"
#include "render/frame/frame_options.h"

namespace prairie {

class World;
struct Pass;

/// One of a frame's views: an eye, and the framebuffer that its picture goes to (0: the window). The camera's
/// size is the framebuffer's.
struct FrameView {
  Camera camera;
  FrameOptions options;
  unsigned target = 0;
};

class Renderer {
 public:
  /// `shader_folder`: where shaders/ was installed (see app/scenes/installed_files.h). Throws
  /// NoSuitableOpenGl, BadInput.
  Renderer(const World& world, const std::filesystem::path& shader_folder);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// What is drawn, in order. Whoever draws something more adds a pass of its own before the first frame.
  std::vector<Pass>& passes();

  /// What is done while a frame is drawn: once all that time moves has been read, it runs beside the drawing
  /// in a thread of its own (afterwards, where oneTBB may use only one) and has ended when the drawing
  /// returns. It may step the world for the next frame, not touch OpenGL. What it throws is passed on.
  using Meanwhile = std::function<void()>;

  /// Draws one frame of these views (at least one), tone-mapped; all show the same moment. A view keeps its
  /// place in the list from frame to frame: its tiers follow its own eye's way. `meanwhile` begins with the
  /// last view's drawing.
  std::vector<FrameStatistics> draw(std::span<const FrameView> views, const Meanwhile& meanwhile = {});
  FrameStatistics draw(const FrameView& view, const Meanwhile& meanwhile = {});

  /// Draws `samples` jittered frames, averages them in linear light and reads the picture back. It depends on
  /// nothing that was drawn before.
  Picture render(const Camera& camera, const FrameOptions& options, int samples,
                 const Meanwhile& meanwhile = {});
  /// Of the picture that `render` drew last.
  const FrameStatistics& picture_statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prairie
