#include "maps/world_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "files/decimal.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kMaxBytes = 4096;

}  // namespace

std::optional<WorldFile> parse_world_file(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::array<double, 6> numbers{};
  for (double& number : numbers) {
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return std::nullopt;
    text.remove_prefix(first);
    const std::size_t length = std::min(text.find_first_of(kBlank), text.size());
    const std::optional<double> parsed = parse_decimal(text.substr(0, length));
    if (!parsed) return std::nullopt;
    number = *parsed;
    text.remove_prefix(length);
  }
  if (text.find_first_not_of(kBlank) != std::string_view::npos) return std::nullopt;
  return WorldFile{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
}

std::optional<std::filesystem::path> find_world_file(const std::filesystem::path& image) {
  const std::string extension = image.extension().string();
  std::vector<std::string> candidates;
  if (extension.size() > 2) {
    candidates.push_back(extension.substr(0, 2) + extension.back() + "w");  // .tif → .tfw
  }
  if (extension.size() > 1) candidates.push_back(extension + "w");  // .tif → .tifw
  candidates.push_back(".wld");
  for (std::string candidate : candidates) {
    for (int upper = 0; upper < 2; ++upper) {
      std::filesystem::path path = image;
      path.replace_extension(candidate);
      std::error_code ignored;
      if (std::filesystem::is_regular_file(path, ignored)) return path;
      std::transform(candidate.begin(), candidate.end(), candidate.begin(),
                     [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
  }
  return std::nullopt;
}

WorldFile read_world_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMaxBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  const std::optional<WorldFile> world =
      text.size() <= kMaxBytes ? parse_world_file(text) : std::optional<WorldFile>();
  if (!world) throw BadInput(path.string(), "", "something else", "a world file: six numbers, one per line");
  return *world;
}

}  // namespace prairie
