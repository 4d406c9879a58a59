// Where results go, checked before the work that makes them is begun.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace prairie {

/// What `-o` is given to mean stdout.
inline constexpr std::string_view kStandardOutput = "-";

/// Throws OutputFailure unless a file can be made, or an ordinary file be replaced, under this name.
void check_output_file(const std::filesystem::path& path);

/// Makes the folder (and those above it) where it is missing. Throws OutputFailure unless files can be made
/// in it.
void make_output_folder(const std::filesystem::path& folder);

/// Writes atomically (files/atomic_file.h), and not interruptibly: the file is whole or not there.
void write_output(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_output(const std::filesystem::path& path, std::string_view text);

}  // namespace prairie
