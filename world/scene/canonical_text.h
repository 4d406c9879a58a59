// What is hashed of settings: a text, a "name=value" line per setting. Numbers are the shortest decimals that
// read back as the same bits, so the text is the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace prairie {

class CanonicalText {
 public:
  void add(std::string_view name, double value);
  void add(std::string_view name, float value);
  void add(std::string_view name, std::uint64_t value);
  void add(std::string_view name, std::uint32_t value);
  void add(std::string_view name, bool value);
  /// An enumerator by its number.
  template <class Choice>
  requires std::is_enum_v<Choice>
  void add(std::string_view name, Choice value) { add(name, static_cast<std::uint64_t>(value)); }
  void add(std::string_view name, const std::string& value);
  void add(std::string_view name, const glm::vec3& value);
  void add(std::string_view name, const glm::dvec3& value);
  void add(std::string_view name, const glm::dvec2& value);
  void add(std::string_view name, const std::array<double, 2>& value);
  /// A line for each.
  void add(std::string_view name, const std::vector<glm::dvec2>& values);
  /// Nothing for nothing.
  template <class Value>
  void add(std::string_view name, const std::optional<Value>& value) {
    if (value) add(name, *value);
  }

  /// XXH3, 64 bits.
  std::uint64_t hash() const;

 private:
  void line(std::string_view name, std::string_view value);

  std::string text_;
};

}  // namespace prairie
