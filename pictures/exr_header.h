// OpenEXR reserves whatever an attribute of the header claims to hold, before it looks whether the file goes
// on for so long: a file of 836 bytes takes two gigabytes. The claims are checked first.
#pragma once

#include <cstdint>
#include <filesystem>

namespace prairie {

/// Whether every attribute in the headers of an OpenEXR file fits into the file, which holds `file_bytes`.
/// True for files that are no OpenEXR.
bool exr_header_fits(const std::filesystem::path& path, std::uint64_t file_bytes);

}  // namespace prairie
