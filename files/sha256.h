// SHA-256 of bytes in memory, by OpenSSL.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace prairie {

/// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace prairie
