// OpenImageIO reserves or even decodes a GIF, a JPEG 2000 or a progressive JPEG image whole while it opens
// the file, before anyone can look at its size; so the size is read from the file's own header first.
#pragma once

#include <cstdint>
#include <filesystem>

namespace prairie {

/// Bytes that the decoder needs for the pixels that the header claims; 0 for files of other formats, or where
/// the header says nothing.
std::uint64_t eagerly_claimed_bytes(const std::filesystem::path& path);

}  // namespace prairie
