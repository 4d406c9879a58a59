// The meadow whose hash every compiler, optimisation level and machine has to agree on: three species,
// feature maps, steep ground. Its maps come from integers and plain arithmetic alone: no library function may
// differ.
#pragma once

#include <cstdint>

namespace prairie {

/// Of all tiles' hashes, in order.
std::uint64_t hashed_meadow_hash();

/// What it was when planting last changed on purpose.
inline constexpr std::uint64_t kHashedMeadowHash = 0x469787829e239f5eull;

}  // namespace prairie
