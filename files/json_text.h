// JSON text out of plain values: objects keep the order of their members. What writes JSON includes this
// instead of a whole JSON library, which json_text.cpp alone needs.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace prairie {

struct JsonMember;
struct JsonValue;
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;

struct JsonValue {
  JsonValue(std::nullptr_t = nullptr) {}
  JsonValue(bool truth) : value(truth) {}
  JsonValue(std::signed_integral auto number) : value(std::int64_t{number}) {}
  JsonValue(std::unsigned_integral auto number) : value(std::uint64_t{number}) {}
  JsonValue(std::floating_point auto number) : value(static_cast<double>(number)) {}
  JsonValue(const char* text) : value(std::string(text)) {}
  JsonValue(std::string text) : value(std::move(text)) {}
  JsonValue(JsonArray array);
  JsonValue(JsonObject object);

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, JsonArray, JsonObject>
      value;
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

inline JsonValue::JsonValue(JsonArray array) : value(std::move(array)) {}
inline JsonValue::JsonValue(JsonObject object) : value(std::move(object)) {}

/// An array of what a JsonValue can be made of.
template <typename Values>
JsonArray json_array(const Values& values) {
  return JsonArray(values.begin(), values.end());
}

/// Indented by two spaces, without a line break at its end. Bytes that are no UTF-8 are replaced, not
/// refused, and numbers that JSON does not know are null. Names in an object are all different.
std::string json_text(const JsonValue& value);

}  // namespace prairie
