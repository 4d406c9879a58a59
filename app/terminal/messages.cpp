#include "app/terminal/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace prairie {
namespace {

constexpr const char* kRed = "\x1b[31m";
constexpr const char* kYellow = "\x1b[33m";
constexpr const char* kPlain = "\x1b[0m";

bool colorful() {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

// A file's name may hold line breaks and terminal commands.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

void say(const char* color, const std::string& lead, const std::string& text) {
  const bool colored = colorful();
  fmt::print(stderr, "{}{}:{} {}\n", colored ? color : "", lead, colored ? kPlain : "", one_line(text));
}

}  // namespace

void say_fault(const std::string& text) {
  say(kRed, "prairie", text);
}

void say_warning(const std::string& text) {
  say(kYellow, "prairie: warning", text);
}

void say_done(const std::string& text, bool quiet) {
  if (!quiet) fmt::print(stderr, "{}\n", one_line(text));
}

}  // namespace prairie
