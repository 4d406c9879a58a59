#include "app/outputs/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "files/error.h"

extern "C" char** environ;

namespace prairie {
namespace {

std::vector<std::string> ffmpeg_command(const std::filesystem::path& output, const VideoFormat& format) {
  std::vector<std::string> words{"ffmpeg", "-hide_banner", "-loglevel", "error", "-y"};
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  add({"-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
       fmt::format("{}x{}", format.size_px.x, format.size_px.y)});
  add({"-framerate", format.frame_rate.text(), "-i", "pipe:0"});
  // Colours as HD video has them, and said so: players guess otherwise, each in its own way.
  add({"-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int"});
  add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range",
       "tv"});
  add({"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"});
  if (format.threads) add({"-threads", std::to_string(*format.threads)});
  // "file:" so that a colon in a name, or a dash before it, is no more than that.
  add({"-f", "mp4", "file:" + output.string()});
  return words;
}

/// What ffmpeg is started with besides its words: where it reads and complains.
class SpawnActions {
 public:
  SpawnActions(int standard_input, int standard_error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, standard_input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, standard_error, STDERR_FILENO);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// The last line that is not empty.
std::string last_line_of(int descriptor) {
  std::string text(4096, '\0');
  const off_t end = lseek(descriptor, 0, SEEK_END);
  const ssize_t count =
      pread(descriptor, text.data(), text.size(), std::max<off_t>(end - static_cast<off_t>(text.size()), 0));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  text.erase(text.find_last_not_of(" \r\n") + 1);
  return text.substr(text.find_last_of('\n') + 1);
}

}  // namespace

VideoFile::VideoFile(const std::filesystem::path& path, const VideoFormat& format)
    : path_(path), output_(path), complaints_(memfd_create("ffmpeg", MFD_CLOEXEC)) {
  const auto failed = [&](int error_number) {
    return OutputFailure(path_.string(), "ffmpeg", std::strerror(error_number),
                         "a program that can be started");
  };
  if (!complaints_.is_open()) throw failed(errno);
  // A socket rather than a pipe: writing to one whose reader has gone can be kept from raising a signal.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw failed(errno);
  frames_.emplace(ends[0]);
  FileDescriptor read_by_ffmpeg(ends[1]);
  std::vector<std::string> words = ffmpeg_command(output_.temporary_path(), format);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  const SpawnActions actions(read_by_ffmpeg.get(), complaints_.get());
  const int error_number =
      posix_spawnp(&process, words.front().c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (error_number == ENOENT) {
    throw OutputFailure(path_.string(), "ffmpeg", "no such program on PATH",
                        "ffmpeg installed, or a folder for single pictures as the output");
  }
  if (error_number != 0) throw failed(error_number);
  ffmpeg_.emplace(process);
}

void VideoFile::write(std::span<const std::uint8_t> srgb) {
  while (!srgb.empty()) {
    const ssize_t sent = send(frames_->get(), srgb.data(), srgb.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail(ffmpeg_->wait());
    srgb = srgb.subspan(static_cast<std::size_t>(sent));
  }
}

void VideoFile::finish() {
  frames_.reset();  // which tells ffmpeg that this was all
  const int status = ffmpeg_->wait();
  if (status != 0) fail(status);
  output_.finish();
}

void VideoFile::fail(int status) {
  const std::string complaint = last_line_of(complaints_.get());
  const std::string end = WIFSIGNALED(status) ? fmt::format("its end by signal {}", WTERMSIG(status))
                                              : fmt::format("its exit code {}", WEXITSTATUS(status));
  throw OutputFailure(path_.string(), "ffmpeg",
                      complaint.empty() ? end : fmt::format("{} ({})", complaint, end),
                      "a clip that it can write");
}

}  // namespace prairie
