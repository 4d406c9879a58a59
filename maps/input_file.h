// A person's file before anything is read from it as an image: that it is a file at all, its size and its
// hash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace prairie {

struct InputFile {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;  // XXH3, 64 bits
};

/// Throws BadInput where `path` is missing, unreadable, empty or not a file (`field` names the key that asked
/// for it).
InputFile inspect_input(const std::filesystem::path& path, const std::string& field);

}  // namespace prairie
