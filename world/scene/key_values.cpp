#include "world/scene/key_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "world/scene/color_text.h"

namespace prairie {
namespace {

/// Without a point TOML would have a whole number.
std::string with_point(std::string text) {
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::optional<double> read_number(TableReader& table, const KeyTraits& key) {
  return key.range ? table.number(key.name, *key.range) : table.any_number(key.name);
}

std::string list_text(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

template <class Number>
std::string numbers_text(std::initializer_list<Number> numbers) {
  std::vector<std::string> texts;
  for (const Number number : numbers) texts.push_back(with_point(fmt::format("{}", number)));
  return list_text(texts);
}

}  // namespace

void read_value(TableReader& table, const KeyTraits& key, double& value) {
  if (const auto number = read_number(table, key)) value = member_from_key(key.unit, *number);
}

void read_value(TableReader& table, const KeyTraits& key, float& value) {
  constexpr double kBeyondAnyRange = 1e30;  // but still a float
  if (const auto number = read_number(table, key)) {
    value =
        static_cast<float>(std::clamp(member_from_key(key.unit, *number), -kBeyondAnyRange, kBeyondAnyRange));
  }
}

void read_value(TableReader& table, const KeyTraits& key, std::uint32_t& value) {
  if (const auto number = table.integer(key.name, 0, std::numeric_limits<std::uint32_t>::max()))
    value = static_cast<std::uint32_t>(*number);
}

void read_value(TableReader& table, const KeyTraits& key, std::uint64_t& value) {
  if (const auto number = table.integer(key.name, 0, std::numeric_limits<std::int64_t>::max()))
    value = static_cast<std::uint64_t>(*number);
}

void read_value(TableReader& table, const KeyTraits& key, bool& value) {
  value = table.flag(key.name).value_or(value);
}

void read_value(TableReader& table, const KeyTraits& key, std::string& value) {
  if (auto text = table.text(key.name)) value = std::move(*text);
}

void read_value(TableReader& table, const KeyTraits& key, glm::vec3& value) {
  assert(key.range);
  value = table.color(key.name, *key.range).value_or(value);
}

void read_value(TableReader& table, const KeyTraits& key, glm::dvec2& value) {
  assert(key.range);
  const auto pair = table.pair(key.name, *key.range);
  if (pair) value = {(*pair)[0], (*pair)[1]};
  if (!pair && key.is_required) table.refuse_missing(key.name, "a place [x, y] in metres");
}

void read_value(TableReader& table, const KeyTraits& key, glm::dvec3& value) {
  assert(key.range);
  value = read_size(table, key.name, *key.range).value_or(value);
}

void read_value(TableReader& table, const KeyTraits& key, std::optional<double>& value) {
  if (const auto number = read_number(table, key)) value = member_from_key(key.unit, *number);
}

void read_value(TableReader& table, const KeyTraits& key, std::optional<std::string>& value) {
  if (auto text = table.text(key.name)) value = std::move(text);
}

void read_value(TableReader& table, const KeyTraits& key, std::optional<std::array<double, 2>>& value) {
  assert(key.range);
  if (const auto pair = table.pair(key.name, *key.range)) value = pair;
}

void read_value(TableReader& table, const KeyTraits& key, std::vector<glm::dvec2>& value) {
  if (auto points_m = read_points(table, key.name, key.counts)) {
    value = std::move(*points_m);
  } else if (key.is_required) {
    refuse_missing_points(table, key.name, key.counts);
  }
}

void read_value(TableReader& table, const KeyTraits& key, std::vector<std::vector<glm::dvec2>>& value) {
  value = read_point_lists(table, key.name, key.counts);
}

std::string value_text(const KeyTraits& key, double value) {
  return number_text(key_from_member(key.unit, value, false));
}

std::string value_text(const KeyTraits& key, float value) {
  return number_text(key_from_member(key.unit, static_cast<double>(value), true));
}

std::string value_text(const KeyTraits&, std::uint32_t value) {
  return fmt::format("{}", value);
}

std::string value_text(const KeyTraits&, std::uint64_t value) {
  return fmt::format("{}", value);
}

std::string value_text(const KeyTraits&, bool value) {
  return value ? "true" : "false";
}

std::string value_text(const KeyTraits&, const std::string& value) {
  return quoted_text(value);
}

std::string value_text(const KeyTraits&, const glm::vec3& value) {
  if (const auto hex = hex_from_linear(value)) return quoted_text(*hex);
  return numbers_text({value.x, value.y, value.z});
}

std::string value_text(const KeyTraits&, const glm::dvec2& value) {
  return numbers_text({value.x, value.y});
}

std::string value_text(const KeyTraits&, const glm::dvec3& value) {
  return numbers_text({value.x, value.y, value.z});
}

std::string value_text(const KeyTraits& key, const std::optional<double>& value) {
  return value ? value_text(key, *value) : std::string();
}

std::string value_text(const KeyTraits&, const std::optional<std::string>& value) {
  return value ? quoted_text(*value) : std::string();
}

std::string value_text(const KeyTraits&, const std::optional<std::array<double, 2>>& value) {
  return value ? numbers_text({(*value)[0], (*value)[1]}) : std::string();
}

std::string value_text(const KeyTraits& key, const std::vector<glm::dvec2>& value) {
  if (value.empty()) return {};
  std::vector<std::string> points;
  for (const glm::dvec2& point : value) points.push_back(value_text(key, point));
  return list_text(points);
}

std::string value_text(const KeyTraits& key, const std::vector<std::vector<glm::dvec2>>& value) {
  if (value.empty()) return {};
  std::vector<std::string> lists;
  for (const std::vector<glm::dvec2>& points : value) lists.push_back(value_text(key, points));
  return list_text(lists);
}

std::string number_text(double value) {
  return with_point(fmt::format("{}", value + 0.0));  // no negative zero
}

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\u{:04x}", code);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace prairie
