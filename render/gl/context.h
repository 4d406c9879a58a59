// OpenGL 4.5 core without a window: an EGL context on a named device, else the first hardware device that
// makes one, else Mesa's surfaceless platform, else a software device.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

struct ContextOptions {
  bool debug = false;  // the driver checks calls more closely and says more (render/gl/gl_debug.h); slower
};

class HeadlessContext {
 public:
  /// `device`: an index or a name (or part of one) from `list_devices`. Throws NoSuitableOpenGl listing every
  /// attempt.
  explicit HeadlessContext(const std::optional<std::string>& device, const ContextOptions& options = {});
  ~HeadlessContext();
  HeadlessContext(HeadlessContext&&) noexcept;
  HeadlessContext& operator=(HeadlessContext&&) noexcept;

 private:
  struct Egl;
  std::unique_ptr<Egl> egl_;
};

/// One line per EGL device, "0: NVIDIA …"; the index is what `--device` takes.
std::vector<std::string> list_devices();

/// "Mesa llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6" of the current context.
std::string renderer_name();

}  // namespace prairie
