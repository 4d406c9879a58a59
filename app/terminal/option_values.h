// The values of command-line options, from text to checked numbers. Every function names the option in the
// UsageError that it throws.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tiles.h"
#include "lod/frame_plan.h"

namespace prairie {

inline constexpr int kMaxPictureSidePx = 16384;  // what every OpenGL 4.5 driver can draw into
inline constexpr int kMaxSamples = 1024;
inline constexpr int kMaxThreads = 1024;

std::vector<std::string> split(std::string_view text, char separator);

int int_option(const std::string& option, const std::string& text, int least, int most);
double number_option(const std::string& option, const std::string& text, double least, double most);

/// Decimal, or hexadecimal after 0x.
std::uint64_t seed_option(const std::string& option, const std::string& text);

/// "512M", "2G", "1.5GiB", "1000000": bytes, with suffixes that count in 1024s.
std::uint64_t bytes_option(const std::string& option, const std::string& text);

/// "800x600"; each side 1…kMaxPictureSidePx.
glm::ivec2 size_option(const std::string& option, const std::string& text);

/// "i0,j0,i1,j1", both corners inclusive, in either order.
TileRange tiles_option(const std::string& option, const std::string& text);

/// "x,y,z", metres in the scene.
glm::dvec3 place_option(const std::string& option, const std::string& text);

Tier tier_option(const std::string& option, const std::string& text);
std::string tier_name(Tier tier);

/// " (did you mean …?)", or nothing where no known word is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// `text`, if it is one of `names`; otherwise the error lists them and says which one was probably meant.
std::string choice_option(const std::string& option, const std::string& text,
                          const std::vector<std::string>& names);

}  // namespace prairie
