// Where the frames of a clip go as they are drawn: into a video, or into a folder of pictures.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>

#include "app/outputs/video_file.h"
#include "app/terminal/frame_rate.h"
#include "pictures/picture.h"

namespace prairie {

struct ClipFormat {
  std::filesystem::path output;  // a video where it ends in .mp4, else a folder
  glm::ivec2 size_px{1280, 720};
  FrameRate frame_rate;
};

class Clip {
 public:
  /// Starts what makes a video of them, so that it is missed before a large scene is read. Throws UsageError
  /// on another kind of file, or a size that a video cannot have; OutputFailure.
  Clip(const ClipFormat& format, const std::optional<int>& threads);

  /// The frames come now.
  void begin();
  void add(const Picture& picture);
  void finish();

  const ClipFormat& format() const { return format_; }

 private:
  ClipFormat format_;
  std::optional<VideoFile> video_;
  int frames_ = 0;
};

}  // namespace prairie
