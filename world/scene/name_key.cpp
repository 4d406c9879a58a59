#include "world/scene/name_key.h"

#include <algorithm>

namespace prairie {
namespace {

// Names are written in overrides ("species.NAME.height_m") and camera arguments ("x,y,z,…"): no dots, no
// commas, and not to be taken for a number.
bool is_name(const std::string& name) {
  constexpr std::size_t kLongestName = 64;
  if (name.empty() || name.size() > kLongestName) return false;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  if (!is_letter(name.front())) return false;
  return std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == ' '; });
}

}  // namespace

std::string read_name(TableReader& table, const KeyTraits& key,
                      const std::function<bool(std::string_view)>& is_taken) {
  constexpr const char* kExpected = "a name: letters, digits, '_', '-' and spaces, a letter first";
  const auto name = table.text(key.name);
  if (!name) table.refuse_missing(key.name, kExpected);
  if (!is_name(*name)) table.refuse(key.name, kExpected);
  if (is_taken(*name)) table.refuse(key.name, "a name not yet given");
  return *name;
}

}  // namespace prairie
