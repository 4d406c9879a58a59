#include "world/scene/canonical_text.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace prairie {

void CanonicalText::add(std::string_view name, double value) {
  line(name, fmt::format("{}", value));
}

void CanonicalText::add(std::string_view name, float value) {
  line(name, fmt::format("{}", value));
}

void CanonicalText::add(std::string_view name, std::uint64_t value) {
  line(name, fmt::format("{}", value));
}

void CanonicalText::add(std::string_view name, std::uint32_t value) {
  add(name, std::uint64_t{value});
}

void CanonicalText::add(std::string_view name, bool value) {
  line(name, value ? "true" : "false");
}

// The length keeps two texts that share a line break apart.
void CanonicalText::add(std::string_view name, const std::string& value) {
  line(name, fmt::format("{}:{}", value.size(), value));
}

void CanonicalText::add(std::string_view name, const glm::vec3& value) {
  line(name, fmt::format("{} {} {}", value.x, value.y, value.z));
}

void CanonicalText::add(std::string_view name, const glm::dvec3& value) {
  line(name, fmt::format("{} {} {}", value.x, value.y, value.z));
}

void CanonicalText::add(std::string_view name, const glm::dvec2& value) {
  line(name, fmt::format("{} {}", value.x, value.y));
}

void CanonicalText::add(std::string_view name, const std::array<double, 2>& value) {
  line(name, fmt::format("{} {}", value[0], value[1]));
}

void CanonicalText::add(std::string_view name, const std::vector<glm::dvec2>& values) {
  for (const glm::dvec2& value : values) add(name, value);
}

std::uint64_t CanonicalText::hash() const {
  return XXH3_64bits(text_.data(), text_.size());
}

void CanonicalText::line(std::string_view name, std::string_view value) {
  text_ += fmt::format("{}={}\n", name, value);
}

}  // namespace prairie
