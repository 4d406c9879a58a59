// Outputs that are either complete or not there: bytes go to a temporary name in the same folder, are flushed
// to the disk, and renamed over the target. A failure leaves what stood there before.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace prairie {

/// Throws OutputFailure (unwritable folder, full disk, …), leaving `path` as it was and no temporary file
/// behind.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace prairie
