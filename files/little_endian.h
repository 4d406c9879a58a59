// Numbers as bytes, least significant first, whatever the machine.
#pragma once

#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace prairie {

template <class Number>
concept FixedWidth = (std::integral<Number> || std::same_as<Number, float> ||
                      std::same_as<Number, double>)&&(sizeof(Number) == 1 || sizeof(Number) == 4 ||
                                                      sizeof(Number) == 8);

template <FixedWidth Number>
using BitsOf = std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>;

/// Needs `to` to be as long as the number.
template <FixedWidth Number>
void put_little_endian(std::span<std::byte> to, Number number) {
  assert(to.size() == sizeof(Number));
  auto bits = std::bit_cast<BitsOf<Number>>(number);
  for (std::byte& byte : to) {
    byte = static_cast<std::byte>(bits & 0xff);
    bits = static_cast<BitsOf<Number>>(sizeof(Number) == 1 ? 0 : bits >> 8);
  }
}

template <FixedWidth Number>
Number little_endian(std::span<const std::byte> from) {
  assert(from.size() == sizeof(Number));
  BitsOf<Number> bits = 0;
  for (std::size_t n = 0; n < sizeof(Number); ++n)
    bits = static_cast<BitsOf<Number>>(bits |
                                       (BitsOf<Number>{std::to_integer<std::uint8_t>(from[n])} << (8 * n)));
  return std::bit_cast<Number>(bits);
}

}  // namespace prairie
