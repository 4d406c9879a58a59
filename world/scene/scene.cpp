#include "world/scene/scene.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <fstream>
#include <system_error>

#include "world/scene/overrides.h"
#include "world/scene/scene_reader.h"

namespace prairie {
namespace {

constexpr std::uintmax_t kLargestFileBytes = 4u << 20;  // a hand-written scene has a few kB
constexpr std::size_t kLongestDescription = 200;

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw BadInput(file.string(), "", "no such file", "a scene folder (`prairie new` makes one)");
  }
  if (!std::filesystem::is_regular_file(status))
    throw BadInput(file.string(), "", "no regular file", "a scene file");
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kLargestFileBytes) {
    throw BadInput(file.string(), "", error ? error.message() : fmt::format("{} bytes", size),
                   fmt::format("a scene file of at most {} bytes", kLargestFileBytes));
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) throw BadInput(file.string(), "", "no way to read it", "a readable file");
  return text;
}

toml::table parsed_table(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    throw BadInput(file, fmt::format("line {}, column {}", at.line, at.column),
                   printable(error.description(), kLongestDescription), "TOML (toml.io)");
  }
}

}  // namespace

Scene parse_scene(std::string_view text, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides) {
  const std::string file = (folder / kSceneFileName).string();
  toml::table table = parsed_table(text, file);
  Scene scene = scene_from_table(table, {.file = file, .has_lines = true}, folder);
  // One at a time, so that a fault is the fault of the override just made.
  for (const std::string& assignment : overrides) {
    apply_override(table, assignment);
    try {
      scene = scene_from_table(table, {.file = file, .has_lines = false}, folder);
    } catch (const BadInput& fault) {
      throw BadOverride("", override_key(assignment), fault.found, fault.expected);
    }
  }
  return scene;
}

Scene read_scene(const std::filesystem::path& folder, const std::vector<std::string>& overrides) {
  return parse_scene(read_text(folder / kSceneFileName), folder, overrides);
}

}  // namespace prairie
