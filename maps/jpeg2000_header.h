// OpenImageIO decodes a JPEG 2000 file whole while it opens it, before anyone can look at its size; so the
// size is read from the file's own header first.
#pragma once

#include <cstdint>
#include <filesystem>

namespace prairie {

/// Bytes that the decoder needs for the pixels that the header claims (32 bits per sample); 0 if `path` is no
/// JPEG 2000 file or its header says nothing.
std::uint64_t jpeg2000_claimed_bytes(const std::filesystem::path& path);

}  // namespace prairie
