// "Did you mean …?": the known word that a mistyped one most likely stands for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace prairie {

/// The word of `known` nearest to `word`, if one is near enough to be what was meant: a few letters wrong,
/// missing, doubled or swapped (optimal string alignment distance, letter case aside), or the unit left off
/// (height for height_m).
std::optional<std::string> suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace prairie
