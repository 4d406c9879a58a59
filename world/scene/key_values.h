// What keys of each type hold: how it is read from a table, and how it is written in TOML.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "world/scene/key_traits.h"
#include "world/scene/toml_reader.h"

namespace prairie {

// Each leaves the value as it is where the key is absent, and throws BadInput where it is required or of
// another type or beyond its range.
void read_value(TableReader& table, const KeyTraits& key, double& value);
void read_value(TableReader& table, const KeyTraits& key, float& value);
void read_value(TableReader& table, const KeyTraits& key, std::uint32_t& value);
void read_value(TableReader& table, const KeyTraits& key, std::uint64_t& value);
void read_value(TableReader& table, const KeyTraits& key, bool& value);
void read_value(TableReader& table, const KeyTraits& key, std::string& value);
/// A colour.
void read_value(TableReader& table, const KeyTraits& key, glm::vec3& value);
void read_value(TableReader& table, const KeyTraits& key, glm::dvec2& value);
/// A size.
void read_value(TableReader& table, const KeyTraits& key, glm::dvec3& value);
void read_value(TableReader& table, const KeyTraits& key, std::optional<double>& value);
void read_value(TableReader& table, const KeyTraits& key, std::optional<std::string>& value);
void read_value(TableReader& table, const KeyTraits& key, std::optional<std::array<double, 2>>& value);
void read_value(TableReader& table, const KeyTraits& key, std::vector<glm::dvec2>& value);
void read_value(TableReader& table, const KeyTraits& key, std::vector<std::vector<glm::dvec2>>& value);
/// One of the key's words.
template <class Choice>
requires std::is_enum_v<Choice>
void read_value(TableReader& table, const KeyTraits& key, Choice& value) {
  if (const auto place = table.choice(key.name, key.words)) value = static_cast<Choice>(*place);
}

// The shortest text that reads back as the same value; empty for none.
std::string value_text(const KeyTraits& key, double value);
std::string value_text(const KeyTraits& key, float value);
std::string value_text(const KeyTraits& key, std::uint32_t value);
std::string value_text(const KeyTraits& key, std::uint64_t value);
std::string value_text(const KeyTraits& key, bool value);
std::string value_text(const KeyTraits& key, const std::string& value);
std::string value_text(const KeyTraits& key, const glm::vec3& value);
std::string value_text(const KeyTraits& key, const glm::dvec2& value);
std::string value_text(const KeyTraits& key, const glm::dvec3& value);
std::string value_text(const KeyTraits& key, const std::optional<double>& value);
std::string value_text(const KeyTraits& key, const std::optional<std::string>& value);
std::string value_text(const KeyTraits& key, const std::optional<std::array<double, 2>>& value);
std::string value_text(const KeyTraits& key, const std::vector<glm::dvec2>& value);
std::string value_text(const KeyTraits& key, const std::vector<std::vector<glm::dvec2>>& value);
template <class Choice>
requires std::is_enum_v<Choice> std::string value_text(const KeyTraits& key, Choice value);

/// A text as TOML has it, in quotes.
std::string quoted_text(std::string_view text);
/// As TOML has it: whole numbers with a decimal point, too.
std::string number_text(double value);

template <class Choice>
requires std::is_enum_v<Choice> std::string value_text(const KeyTraits& key, Choice value) {
  return quoted_text(key.words.at(static_cast<std::size_t>(value)));
}

}  // namespace prairie
