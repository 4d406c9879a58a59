// A clip as an MP4 file (H.264), made by the program ffmpeg, which frames are sent to as they are drawn.
// Whole or not there, like all outputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "app/outputs/streamed_output.h"
#include "app/terminal/frame_rate.h"
#include "app/terminal/interruption.h"
#include "files/file_descriptor.h"

namespace prairie {

struct VideoFormat {
  glm::ivec2 size_px{1280, 720};  // even: H.264 keeps colours for 2 × 2 pixels
  FrameRate frame_rate;
  std::optional<int> threads;  // all cores, if not given
};

class VideoFile {
 public:
  /// Starts ffmpeg. Throws OutputFailure where there is none on PATH, or the file cannot be made.
  VideoFile(const std::filesystem::path& path, const VideoFormat& format);
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// A frame: red, green and blue of each pixel, sRGB, rows from the top. Throws OutputFailure, with ffmpeg's
  /// own words, if it has given up.
  void write(std::span<const std::uint8_t> srgb);
  /// The last call: lets ffmpeg finish and puts the clip in place.
  void finish();

 private:
  [[noreturn]] void fail(int status);

  std::filesystem::path path_;
  StreamedOutput output_;
  FileDescriptor complaints_;             // what ffmpeg writes to stderr
  std::optional<FileDescriptor> frames_;  // our end of what ffmpeg reads
  std::optional<StartedProcess> ffmpeg_;
};

}  // namespace prairie
