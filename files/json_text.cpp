#include "files/json_text.h"

#include <nlohmann/json.hpp>

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

std::string json_text(const JsonValue& value) {
  constexpr int kIndent = 2;
  return std::visit(ToJson(), value.value).dump(kIndent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace prairie
