#include "files/json_text.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace prairie {
namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
  template <typename Plain>
  Json operator()(const Plain& plain) const {
    return plain;
  }
  Json operator()(const JsonArray& array) const {
    Json json = Json::array();
    for (const JsonValue& element : array) json.push_back(std::visit(*this, element.value));
    return json;
  }
  Json operator()(const JsonObject& object) const {
    Json json = Json::object();
    for (const JsonMember& member : object) json[member.name] = std::visit(*this, member.value.value);
    return json;
  }
};

}  // namespace

JsonValue::JsonValue(std::nullptr_t) {}
JsonValue::JsonValue(bool truth) : value(truth) {}
JsonValue::JsonValue(int number) : value(std::int64_t{number}) {}
JsonValue::JsonValue(unsigned number) : value(std::uint64_t{number}) {}
JsonValue::JsonValue(std::int64_t number) : value(number) {}
JsonValue::JsonValue(std::uint64_t number) : value(number) {}
JsonValue::JsonValue(float number) : value(double{number}) {}
JsonValue::JsonValue(double number) : value(number) {}
JsonValue::JsonValue(const char* text) : value(std::string(text)) {}
JsonValue::JsonValue(std::string text) : value(std::move(text)) {}
JsonValue::JsonValue(JsonArray array) : value(std::move(array)) {}
JsonValue::JsonValue(JsonObject object) : value(std::move(object)) {}
JsonValue::JsonValue(const JsonValue&) = default;
JsonValue::JsonValue(JsonValue&&) noexcept = default;
JsonValue& JsonValue::operator=(const JsonValue&) = default;
JsonValue& JsonValue::operator=(JsonValue&&) noexcept = default;
JsonValue::~JsonValue() = default;

std::string json_text(const JsonValue& value) {
  constexpr int kIndent = 2;
  return std::visit(ToJson(), value.value).dump(kIndent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace prairie
