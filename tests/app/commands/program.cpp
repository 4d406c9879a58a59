#include "tests/app/commands/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace prairie::testing {
namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::filesystem::path scratch_file() {
  std::string name = (std::filesystem::temp_directory_path() / "prairie-output-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error("no scratch file " + name);
  close(descriptor);
  return name;
}

std::string taken_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove(path);
  return text;
}

void redirect(int descriptor, const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_WRONLY | O_TRUNC);
  dup2(file, descriptor);
  close(file);
}

[[noreturn]] void become(const Call& call) {
  if (!call.folder.empty() && chdir(call.folder.c_str()) != 0) _exit(126);
  for (const auto& [name, value] : call.environment) setenv(name.c_str(), value.c_str(), 1);
  if (call.before_start) call.before_start();
  std::string program = call.program.string();
  std::vector<std::string> words = call.arguments;
  std::vector<char*> argv{program.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execvp(program.c_str(), argv.data());
  _exit(127);
}

}  // namespace

Running::Running(const Call& call) : out_(scratch_file()), err_(scratch_file()), started_s_(now_s()) {
  process_ = fork();
  if (process_ != 0) return;
  redirect(STDOUT_FILENO, out_);
  redirect(STDERR_FILENO, err_);
  become(call);
}

Running::~Running() {
  if (process_ > 0) finish();
}

Outcome Running::finish() {
  int status = 0;
  rusage usage{};
  wait4(process_, &status, 0, &usage);
  process_ = -1;
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.seconds = now_s() - started_s_;
  outcome.largest_memory_mib = usage.ru_maxrss / 1024;
  outcome.out = taken_text(out_);
  outcome.err = taken_text(err_);
  return outcome;
}

Outcome run(const Call& call) {
  return Running(call).finish();
}

Outcome prairie(const std::vector<std::string>& arguments) {
  Call call;
  call.arguments = arguments;
  return run(call);
}

}  // namespace prairie::testing
