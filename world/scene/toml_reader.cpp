#include "world/scene/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/error.h"
#include "files/suggestion.h"
#include "world/scene/color_text.h"

namespace prairie {
namespace {

std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the text \"{}\"", printable(text->get()));
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* real = node.as_floating_point()) return fmt::format("{}", real->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* list = node.as_array()) return fmt::format("a list of {}", list->size());
  if (node.is_table()) return "a table";
  return "a date or time";
}

std::string expected_number(Bounds bounds) {
  return fmt::format("a number from {} to {}", bounds.min, bounds.max);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  const auto continues_letter = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;
  };
  std::size_t length = std::min(text.size(), longest);
  while (length > 0 && length < text.size() && continues_letter(length)) --length;
  std::string line(text.substr(0, length));
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return length < text.size() ? line + "..." : line;
}

TableReader::TableReader(TomlOrigin origin, std::string path, const toml::table& table)
    : origin_(std::move(origin)), path_(std::move(path)), table_(&table) {}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? printable(key) : fmt::format("{}.{}", path_, printable(key));
}

void TableReader::refuse(std::string_view key, const std::string& found, const std::string& expected) const {
  const toml::node* value = table_->get(key);
  const auto line = value != nullptr ? value->source().begin.line : 0;
  const bool tells_line = origin_.has_lines && line > 0;
  throw BadInput(origin_.file, path_of(key), tells_line ? fmt::format("{} in line {}", found, line) : found,
                 expected);
}

void TableReader::refuse(std::string_view key, const std::string& expected) const {
  const toml::node* value = table_->get(key);
  refuse(key, value != nullptr ? described(*value) : "nothing", expected);
}

void TableReader::refuse_unknown(const std::string& key) const {
  const std::optional<std::string> meant = suggestion(key, known_);
  const std::string found = fmt::format("unknown key '{}'", printable(key));
  if (meant) refuse(key, found, fmt::format("a known one; did you mean '{}'?", *meant));
  refuse(key, found, fmt::format("one of {}", fmt::join(known_, ", ")));
}

std::optional<std::string> TableReader::first_unknown_key() const {
  for (const auto& [key, value] : *table_) {
    const bool is_known = std::find(known_.begin(), known_.end(), key.str()) != known_.end();
    if (!is_known) return std::string(key.str());
  }
  return std::nullopt;
}

void TableReader::refuse_unknown_keys() const {
  if (const auto key = first_unknown_key()) refuse_unknown(*key);
}

void TableReader::refuse_missing(std::string_view key, std::string_view expected) const {
  const std::vector<std::string> wanted{std::string(key)};
  for (const auto& [present, value] : *table_) {
    const bool is_known = std::find(known_.begin(), known_.end(), present.str()) != known_.end();
    if (!is_known && suggestion(present.str(), wanted)) refuse_unknown(std::string(present.str()));
  }
  refuse(key, "nothing", std::string(expected));
}

const toml::node* TableReader::node(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_->get(key);
}

bool TableReader::has(std::string_view key) const {
  return table_->get(key) != nullptr;
}

bool TableReader::holds_table(std::string_view key) const {
  const toml::node* value = table_->get(key);
  return value != nullptr && value->is_table();
}

bool TableReader::holds_number(std::string_view key) const {
  const toml::node* value = table_->get(key);
  return value != nullptr && value->is_number();
}

double TableReader::checked_number(std::string_view key, const toml::node& value, Bounds bounds) const {
  double number = 0.0;
  if (const auto* whole = value.as_integer()) {
    number = static_cast<double>(whole->get());
  } else if (const auto* real = value.as_floating_point()) {
    number = real->get();
  } else {
    refuse(key, described(value), expected_number(bounds));
  }
  const bool is_inside = number >= bounds.min && number <= bounds.max;  // false for NaN
  if (!is_inside) refuse(key, described(value), expected_number(bounds));
  return number + 0.0;  // a negative zero would give another scene hash than zero
}

std::optional<double> TableReader::number(std::string_view key, Bounds bounds) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  return checked_number(key, *value, bounds);
}

std::optional<double> TableReader::any_number(std::string_view key) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* whole = value->as_integer()) return static_cast<double>(whole->get());
  if (const auto* real = value->as_floating_point()) return real->get() + 0.0;  // no negative zero
  refuse(key, "a number");
}

std::optional<std::int64_t> TableReader::integer(std::string_view key, std::int64_t min, std::int64_t max) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  const auto* whole = value->as_integer();
  if (whole == nullptr || whole->get() < min || whole->get() > max) {
    refuse(key, fmt::format("a whole number from {} to {}", min, max));
  }
  return whole->get();
}

std::optional<bool> TableReader::flag(std::string_view key) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  const auto* truth = value->as_boolean();
  if (truth == nullptr) refuse(key, "true or false");
  return truth->get();
}

std::optional<std::string> TableReader::text(std::string_view key) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  const auto* text = value->as_string();
  if (text == nullptr) refuse(key, "a text in quotes");
  return text->get();
}

std::optional<std::size_t> TableReader::choice(std::string_view key, const std::vector<std::string>& words) {
  const auto word = text(key);
  if (!word) return std::nullopt;
  for (std::size_t n = 0; n < words.size(); ++n) {
    if (words[n] == *word) return n;
  }
  const std::string expected = fmt::format("{}", fmt::join(words, " or "));
  const auto meant = suggestion(*word, words);
  refuse(key, meant ? fmt::format("{}; did you mean '{}'?", expected, *meant) : expected);
}

std::optional<std::array<double, 2>> TableReader::pair(std::string_view key, Bounds bounds) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 2) refuse(key, "a list of two numbers");
  return std::array{checked_number(key, (*list)[0], bounds), checked_number(key, (*list)[1], bounds)};
}

std::optional<glm::vec3> TableReader::color(std::string_view key, Bounds bounds) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  constexpr const char* kExpected = "a colour: \"#rrggbb\" (sRGB) or [r, g, b] (linear)";
  if (const auto* text = value->as_string()) {
    const auto parsed = linear_from_hex(text->get());
    if (!parsed) refuse(key, kExpected);
    return parsed;
  }
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 3) refuse(key, kExpected);
  glm::vec3 linear;
  for (int c = 0; c < 3; ++c) {
    linear[c] = static_cast<float>(checked_number(key, (*list)[static_cast<std::size_t>(c)], bounds));
  }
  return linear;
}

std::optional<TableReader> TableReader::table(std::string_view key) {
  const toml::node* value = node(key);
  if (value == nullptr) return std::nullopt;
  const auto* inner = value->as_table();
  if (inner == nullptr) refuse(key, "a table");
  return TableReader(origin_, path_of(key), *inner);
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  const toml::node* value = node(key);
  if (value == nullptr) return {};
  const auto* list = value->as_array();
  const std::string expected = fmt::format("tables, each headed [[{}]]", path_of(key));
  if (list == nullptr) refuse(key, expected);
  std::vector<TableReader> readers;
  for (const toml::node& element : *list) {
    const auto* inner = element.as_table();
    if (inner == nullptr) refuse(key, expected);
    readers.emplace_back(origin_, fmt::format("{}.{}", path_of(key), readers.size()), *inner);
  }
  return readers;
}

}  // namespace prairie
