#include "world/scene/overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <charconv>
#include <optional>
#include <vector>

#include "world/scene/scene.h"
#include "world/scene/toml_reader.h"

namespace prairie {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse(std::string_view assignment, const std::string& found, const std::string& expected) {
  throw BadOverride("", override_key(assignment), found, expected);
}

// A TOML document of one key holds the value; text that is none (high, #ff0000, maps/a.tif) stays text.
void insert_value(toml::table& into, std::string_view key, std::string_view value) {
  constexpr const char* kKey = "value";
  try {
    toml::table document = toml::parse(fmt::format("{} = {}", kKey, value));
    toml::node* parsed = document.get(kKey);
    if (document.size() == 1 && parsed != nullptr) {
      parsed->visit([&](auto& node) { into.insert_or_assign(key, std::move(node)); });
      return;
    }
  } catch (const toml::parse_error&) {
    // Falls through to text.
  }
  into.insert_or_assign(key, std::string(value));
}

std::optional<std::size_t> index_from(std::string_view segment) {
  std::size_t index = 0;
  const auto result = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (result.ec != std::errc() || result.ptr != segment.data() + segment.size()) return std::nullopt;
  return index;
}

std::optional<std::string> name_of(const toml::node& element) {
  const auto* table = element.as_table();
  const auto* name = table != nullptr ? table->get_as<std::string>("name") : nullptr;
  return name != nullptr ? std::optional(name->get()) : std::nullopt;
}

toml::table& element_of(toml::array& list, std::string_view list_key, std::string_view segment,
                        std::string_view assignment) {
  std::vector<std::string> names;
  const auto index = index_from(segment);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto name = name_of(list[i]);
    if (name) names.push_back(*name);
    const bool is_meant = index ? *index == i : name == segment;
    if (is_meant && list[i].is_table()) return *list[i].as_table();
  }
  refuse(assignment, fmt::format("no {} '{}'", printable(list_key), printable(segment)),
         list.empty()
             ? std::string("a key of the scene")
             : fmt::format("an index from 0 to {} or a name: {}", list.size() - 1, fmt::join(names, ", ")));
}

}  // namespace

std::string override_key(std::string_view assignment) {
  return fmt::format("--set {}", printable(trimmed(assignment.substr(0, assignment.find('=')))));
}

void apply_override(toml::table& table, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos) refuse(assignment, "no '='", "KEY=VALUE");
  std::string_view rest = trimmed(assignment.substr(0, equals));
  const std::string_view value = trimmed(assignment.substr(equals + 1));
  if (value.empty()) refuse(assignment, "no value", "KEY=VALUE");

  toml::table* current = &table;
  for (;;) {
    const auto dot = rest.find('.');
    const std::string_view segment = rest.substr(0, dot);
    if (segment.empty())
      refuse(assignment, "an empty part of a key", "a key like lod.quality or species.0.height_m");
    if (dot == std::string_view::npos) {
      insert_value(*current, segment, value);
      return;
    }
    rest.remove_prefix(dot + 1);
    toml::node* next = current->get(segment);
    if (next == nullptr) next = &current->insert_or_assign(segment, toml::table{}).first->second;
    if (auto* list = next->as_array()) {
      const auto element_dot = rest.find('.');
      if (element_dot == std::string_view::npos) {
        refuse(assignment, fmt::format("a whole {}", printable(segment)),
               "one of its keys, as in species.0.height_m");
      }
      current = &element_of(*list, segment, rest.substr(0, element_dot), assignment);
      rest.remove_prefix(element_dot + 1);
      continue;
    }
    if (!next->is_table()) {
      refuse(assignment, fmt::format("'{}', which holds no keys", printable(segment)), "a key of the scene");
    }
    current = next->as_table();
  }
}

}  // namespace prairie
