#include "app/terminal/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "app/terminal/usage_error.h"
#include "files/joined.h"
#include "files/suggestion.h"

namespace prairie {
namespace {

template <typename Number>
std::optional<Number> whole_number(std::string_view text, int base = 10) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

constexpr std::array<std::pair<Tier, std::string_view>, 5> kTierNames{{{Tier::kAuto, "auto"},
                                                                       {Tier::kSpline, "spline"},
                                                                       {Tier::kHermite, "hermite"},
                                                                       {Tier::kStrip, "strip"},
                                                                       {Tier::kFlat, "flat"}}};

}  // namespace

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

int int_option(const std::string& option, const std::string& text, int least, int most) {
  const auto value = whole_number<int>(text);
  if (!value || *value < least || *value > most) {
    throw UsageError(option, text, fmt::format("a whole number from {} to {}", least, most));
  }
  return *value;
}

double number_option(const std::string& option, const std::string& text, double least, double most) {
  const auto value = finite_number(text);
  if (!value || *value < least || *value > most) {
    throw UsageError(option, text, fmt::format("a number from {} to {}", least, most));
  }
  return *value;
}

std::uint64_t seed_option(const std::string& option, const std::string& text) {
  const auto value = text.starts_with("0x")
                         ? whole_number<std::uint64_t>(std::string_view(text).substr(2), 16)
                         : whole_number<std::uint64_t>(text);
  if (!value) throw UsageError(option, text, "a whole number from 0 to 18446744073709551615");
  return *value;
}

std::uint64_t bytes_option(const std::string& option, const std::string& text) {
  const UsageError error(option, text, "a number of bytes such as 512M or 2G");
  const std::size_t digits = text.find_first_not_of("0123456789.");
  const auto number = finite_number(std::string_view(text).substr(0, digits));
  std::string suffix = digits == std::string::npos ? "" : text.substr(digits);
  std::ranges::transform(suffix, suffix.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
  if (suffix.ends_with('B')) suffix.pop_back();
  if (suffix.ends_with('I')) suffix.pop_back();
  constexpr std::string_view kPrefixes = "KMGT";
  double bytes = number.value_or(-1.0);
  if (!suffix.empty()) {
    const std::size_t prefix = suffix.size() == 1 ? kPrefixes.find(suffix[0]) : std::string_view::npos;
    if (prefix == std::string_view::npos) throw error;
    bytes *= std::ldexp(1.0, static_cast<int>(prefix + 1) * 10);
  }
  if (bytes < 1.0 || bytes > 0x1p62) throw error;
  return static_cast<std::uint64_t>(bytes);
}

glm::ivec2 size_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.size() == 2) {
    const auto width = whole_number<int>(sides[0]);
    const auto height = whole_number<int>(sides[1]);
    const auto fits = [](std::optional<int> side) {
      return side && *side >= 1 && *side <= kMaxPictureSidePx;
    };
    if (fits(width) && fits(height)) return {*width, *height};
  }
  throw UsageError(option, text, fmt::format("WIDTHxHEIGHT in pixels, each from 1 to {}", kMaxPictureSidePx));
}

// Endless ground has no last tile, but numbers of tiles must stay numbers.
constexpr std::int64_t kFarthestTile = 1'000'000;

TileRange tiles_option(const std::string& option, const std::string& text) {
  std::array<int, 4> corners{};
  const std::vector<std::string> parts = split(text, ',');
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto value = parts.size() == corners.size() ? whole_number<int>(parts[k]) : std::nullopt;
    if (!value || std::abs(std::int64_t{*value}) > kFarthestTile) {
      throw UsageError(option, text,
                       fmt::format("four whole numbers i0,j0,i1,j1 from -{0} to {0}, both corners inclusive",
                                   kFarthestTile));
    }
    corners[k] = *value;
  }
  const auto [i0, j0, i1, j1] = corners;
  return {{std::min(i0, i1), std::min(j0, j1)}, {std::max(i0, i1), std::max(j0, j1)}};
}

glm::dvec3 place_option(const std::string& option, const std::string& text) {
  constexpr double kFarthestM = 1e7;
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) throw UsageError(option, text, "three numbers x,y,z in metres");
  glm::dvec3 place_m;
  for (int axis = 0; axis < 3; ++axis)
    place_m[axis] = number_option(option, parts[axis], -kFarthestM, kFarthestM);
  return place_m;
}

Tier tier_option(const std::string& option, const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [tier, name] : kTierNames) names.emplace_back(name);
  choice_option(option, text, names);
  return std::ranges::find(kTierNames, text, [](const auto& entry) { return entry.second; })->first;
}

std::string tier_name(Tier tier) {
  return std::string(
      std::ranges::find(kTierNames, tier, [](const auto& entry) { return entry.first; })->second);
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto meant = suggestion(word, known);
  return meant ? fmt::format(" (did you mean {}?)", *meant) : "";
}

std::string choice_option(const std::string& option, const std::string& text,
                          const std::vector<std::string>& names) {
  if (std::ranges::find(names, text) != names.end()) return text;
  throw UsageError(option, text + did_you_mean(text, names), "one of " + joined(names, ", "));
}

}  // namespace prairie
