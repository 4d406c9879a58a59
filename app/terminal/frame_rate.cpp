#include "app/terminal/frame_rate.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

constexpr int kLargestPart = 1'000'000;

[[noreturn]] void refuse(const std::string& option, const std::string& text) {
  throw UsageError(
      option, text,
      fmt::format("a number, or a quotient such as 30000/1001, above 0 and at most {}", kMostFramesPerS));
}

FrameRate checked(const std::string& option, const std::string& text, long long frames, long long seconds) {
  const long long common = std::gcd(frames, seconds);
  const FrameRate rate{static_cast<int>(frames / common), static_cast<int>(seconds / common)};
  if (!(rate.per_s() <= kMostFramesPerS)) refuse(option, text);
  return rate;
}

}  // namespace

std::string FrameRate::text() const {
  return seconds == 1 ? fmt::format("{}", frames) : fmt::format("{}/{}", frames, seconds);
}

FrameRate frame_rate_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() == 2) {
    return checked(option, text, int_option(option, parts[0], 1, kLargestPart),
                   int_option(option, parts[1], 1, kLargestPart));
  }
  if (parts.size() != 1) refuse(option, text);
  const double number = number_option(option, text, 1e-3, kMostFramesPerS);
  if (number == std::trunc(number)) return {static_cast<int>(number), 1};
  // The rates of television, as they are written.
  for (const int whole : {24, 30, 60, 120}) {
    const double meant = whole * 1000.0 / 1001.0;
    if (std::abs(number - meant) < 0.006) return {whole * 1000, 1001};
  }
  constexpr int kThousand = 1000;
  return checked(option, text, std::llround(number * kThousand), kThousand);
}

}  // namespace prairie
