#include "bench/scale_child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_folder.h"
#include "bench/scale_scene.h"
#include "bench/scale_target.h"
#include "files/error.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"

extern char** environ;

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstFrame = "first_frame_at_s";  // on the clock that all processes share
constexpr const char* kPeak = "peak_rss_mb";

struct ChildMeasurements {
  double startup_s = 0.0;  // from before the process to the end of the first frame
  double peak_rss_mb = 0.0;
};

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Not getrusage(): its maximum counts what the parent held when it started the child.
double peak_rss_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kb = 0.0;
    if (word == "VmHWM:" && status >> kb) return kb / 1024.0;
  }
  return 0.0;
}

[[noreturn]] void fail(const std::string& task, const std::string& found) {
  throw OutputFailure("/proc/self/exe", "bench " + task, found, "a child process that measures");
}

/// The environment with shader caches in `folder`.
std::vector<std::string> environment_with_caches_in(const fs::path& folder) {
  const std::vector<std::string> own = {
      "MESA_SHADER_CACHE_DIR=", "XDG_CACHE_HOME=", "__GL_SHADER_DISK_CACHE_PATH="};
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  for (const std::string& name : own) {
    std::erase_if(variables, [&](const std::string& variable) { return variable.starts_with(name); });
    variables.push_back(name + folder.string());
  }
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Runs this program and returns what it prints.
std::string output_of(const std::string& task, std::vector<std::string> arguments,
                      std::vector<std::string> variables) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) fail(task, std::generic_category().message(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
  pid_t child = 0;
  const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers_to(arguments).data(),
                                pointers_to(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  std::string output;
  std::array<char, 4096> piece{};
  for (ssize_t bytes = 0; error == 0 && (bytes = read(pipe_ends[0], piece.data(), piece.size())) != 0;) {
    if (bytes > 0) output.append(piece.data(), static_cast<std::size_t>(bytes));
    if (bytes < 0 && errno != EINTR) break;
  }
  close(pipe_ends[0]);
  if (error != 0) fail(task, std::generic_category().message(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail(task, "a child process that failed");
  return output;
}

/// Runs this program again as `prairie bench TASK --child FOLDER`, with no shaders cached.
ChildMeasurements run_scale_process(const std::string& task, const fs::path& folder,
                                    const BenchOptions& options) {
  const BenchFolder caches;
  std::vector<std::string> arguments = {"prairie", "bench", task, "--child", folder.string()};
  if (options.device) arguments.insert(arguments.end(), {"--device", *options.device});
  const double start_s = now_s();
  std::istringstream lines(output_of(task, arguments, environment_with_caches_in(caches.path())));
  ChildMeasurements measurements;
  std::string name;
  for (double value = 0.0; lines >> name >> value;) {
    if (name == kFirstFrame) measurements.startup_s = value - start_s;
    if (name == kPeak) measurements.peak_rss_mb = value;
  }
  return measurements;
}

}  // namespace

std::vector<Measurement> run_scale_child(const std::string& task, const fs::path& folder,
                                         const BenchOptions& options) {
  const ScaleGround ground = scale_ground(folder);
  const World world = scale_world(ground, {.repeats = task == kRepeatedWalkTask});
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  Renderer renderer(world, options.shader_folder);
  double first_frame_at_s = 0.0;
  for (int frame = 0; frame < kWalkFrames; ++frame) {
    renderer.draw({walk_camera(world, frame), {}, target.framebuffer()});
    glFinish();
    if (frame == 0) first_frame_at_s = now_s();
  }
  return {{kFirstFrame, first_frame_at_s}, {kPeak, peak_rss_mb()}};
}

std::vector<Measurement> bench_scale_processes(const BenchOptions& options) {
  const BenchFolder folder;
  scale_ground(folder.path());  // made here, so that no child spends its time on it
  const ChildMeasurements plain = run_scale_process(kWalkTask, folder.path(), options);
  const ChildMeasurements repeated = run_scale_process(kRepeatedWalkTask, folder.path(), options);
  return {{"scale.startup_s", plain.startup_s},
          {"scale.peak_rss_mb", plain.peak_rss_mb},
          {"scale.repeat10_extra_mb", repeated.peak_rss_mb - plain.peak_rss_mb}};
}

}  // namespace prairie
