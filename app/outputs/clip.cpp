#include "app/outputs/clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/terminal/messages.h"
#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

bool has_suffix(const std::filesystem::path& path, std::string_view suffix) {
  std::string own = path.extension().string();
  std::ranges::transform(own, own.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return own == suffix;
}

/// Whether the output is a video; if not, it is a folder.
bool is_video(const ClipFormat& format) {
  if (std::filesystem::is_directory(format.output)) return false;
  if (has_suffix(format.output, ".mp4")) {
    if (format.size_px.x % 2 == 0 && format.size_px.y % 2 == 0) return true;
    throw UsageError("--size", fmt::format("{}x{}", format.size_px.x, format.size_px.y),
                     "an even width and an even height, which H.264 video needs, or a folder as the output");
  }
  for (const char* other : {".mov", ".mkv", ".avi", ".webm", ".m4v", ".gif", ".png", ".jpg", ".exr"}) {
    if (has_suffix(format.output, other))
      throw UsageError("--output", format.output.string(), "a file name that ends in .mp4, or a folder");
  }
  return false;
}

std::filesystem::path frame_file(const std::filesystem::path& folder, int frame) {
  return folder / fmt::format("frame-{:05}.png", frame);
}

}  // namespace

Clip::Clip(const ClipFormat& format, const std::optional<int>& threads) : format_(format) {
  if (is_video(format))
    video_.emplace(format.output, VideoFormat{format.size_px, format.frame_rate, threads});
}

void Clip::begin() {
  if (!video_) make_output_folder(format_.output);
}

void Clip::add(const Picture& picture) {
  if (video_) {
    video_->write(picture.srgb);
  } else {
    write_output(frame_file(format_.output, frames_), encoded_picture(picture, PictureFormat::kPng));
  }
  ++frames_;
}

void Clip::finish() {
  if (video_) video_->finish();
  if (!video_ && std::filesystem::exists(frame_file(format_.output, frames_)))
    say_warning(fmt::format("{}: frames of an earlier, longer clip follow those of this one",
                            format_.output.string()));
}

}  // namespace prairie
