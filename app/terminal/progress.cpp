#include "app/terminal/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>
#include <utility>

namespace prairie {
namespace {

constexpr std::chrono::milliseconds kInterval{100};
constexpr const char* kWipeLine = "\r\x1b[K";

bool terminal_can_overwrite() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && (term == nullptr || std::string_view(term) != "dumb");
}

}  // namespace

Progress::Progress(std::string what, std::uint64_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      shown_(!quiet && terminal_can_overwrite()),
      next_(std::chrono::steady_clock::now() + kInterval) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "{}", kWipeLine);
}

void Progress::advance() {
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || now < next_) return;
  next_ = now + kInterval;
  fmt::print(stderr, "{}{} {} of {}", kWipeLine, what_, done_, total_);
  std::fflush(stderr);
}

}  // namespace prairie
