// A person's file before anything is made of its contents: that it is a file at all, its size, its hash, its
// bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace prairie {

struct InputFile {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;  // XXH3, 64 bits
};

/// Throws BadInput where `path` is missing, unreadable, empty or not a file (`field` names the key that asked
/// for it).
InputFile inspect_input(const std::filesystem::path& path, const std::string& field);

/// Of several files, one after the other: bytes and hash of all.
InputFile inspect_inputs(const std::vector<std::filesystem::path>& paths, const std::string& field);

/// Throws as inspect_input does, without reading the file.
void check_input(const std::filesystem::path& path, const std::string& field);

/// The whole file. Throws BadInput as inspect_input does, and where it is longer than `most_bytes`.
std::vector<std::byte> read_input(const std::filesystem::path& path, const std::string& field,
                                  std::uint64_t most_bytes);

}  // namespace prairie
