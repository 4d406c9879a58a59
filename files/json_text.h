// JSON text out of plain values: objects keep the order of their members. What writes JSON includes this
// instead of a whole JSON library, which json_text.cpp alone needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace prairie {

struct JsonMember;
struct JsonValue;
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;

struct JsonValue {
  JsonValue(std::nullptr_t = nullptr);
  JsonValue(bool truth);
  JsonValue(int number);
  JsonValue(unsigned number);
  JsonValue(std::int64_t number);
  JsonValue(std::uint64_t number);
  JsonValue(float number);
  JsonValue(double number);
  JsonValue(const char* text);
  JsonValue(std::string text);
  JsonValue(JsonArray array);
  JsonValue(JsonObject object);
  JsonValue(const JsonValue&);
  JsonValue(JsonValue&&) noexcept;
  JsonValue& operator=(const JsonValue&);
  JsonValue& operator=(JsonValue&&) noexcept;
  ~JsonValue();

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, JsonArray, JsonObject>
      value;
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

/// An array of what a JsonValue can be made of.
template <typename Values>
JsonArray json_array(const Values& values) {
  return JsonArray(values.begin(), values.end());
}

/// Indented by two spaces, without a line break at its end. Bytes that are no UTF-8 are replaced, not
/// refused, and numbers that JSON does not know are null. Names in an object are all different.
std::string json_text(const JsonValue& value);

}  // namespace prairie
