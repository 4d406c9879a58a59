#include "world/scene/file_key.h"

#include "world/scene/key_values.h"

namespace prairie {

std::optional<std::filesystem::path> read_path(TableReader& table, const KeyTraits& key, const Scene& so_far,
                                               const char* expected) {
  const auto path = table.text(key.name);
  if (!path) return std::nullopt;
  if (path->empty() || path->find('\0') != std::string::npos) table.refuse(key.name, expected);
  return so_far.folder / *path;
}

std::string path_text(const Scene& scene, const std::filesystem::path& file) {
  const std::filesystem::path relative = file.lexically_relative(scene.folder);
  return quoted_text((relative.empty() ? file : relative).generic_string());
}

}  // namespace prairie
