#include "world/scene/point_list.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "world/scene/key_ranges.h"

namespace prairie {
namespace {

std::string expected(PointCounts counts) {
  return fmt::format("{} to {} points [[x, y], …] in metres", counts.least, counts.most);
}

std::vector<glm::dvec2> points_of(const TableReader& table, std::string_view key, const toml::node& value,
                                  PointCounts counts) {
  const auto* list = value.as_array();
  if (list == nullptr || list->size() < counts.least || list->size() > counts.most)
    table.refuse(key, expected(counts));
  std::vector<glm::dvec2> points_m;
  for (const toml::node& element : *list) {
    const auto* point = element.as_array();
    if (point == nullptr || point->size() != 2)
      table.refuse(key, fmt::format("no [x, y] as point {}", points_m.size()), expected(counts));
    points_m.emplace_back(table.checked_number(key, (*point)[0], kPositionM),
                          table.checked_number(key, (*point)[1], kPositionM));
  }
  return points_m;
}

}  // namespace

std::optional<std::vector<glm::dvec2>> read_points(TableReader& table, std::string_view key,
                                                   PointCounts counts) {
  const toml::node* value = table.node(key);
  if (value == nullptr) return std::nullopt;
  return points_of(table, key, *value, counts);
}

void refuse_missing_points(const TableReader& table, std::string_view key, PointCounts counts) {
  table.refuse_missing(key, expected(counts));
}

std::vector<std::vector<glm::dvec2>> read_point_lists(TableReader& table, std::string_view key,
                                                      PointCounts counts) {
  std::vector<std::vector<glm::dvec2>> lists;
  const toml::node* value = table.node(key);
  if (value == nullptr) return lists;
  const auto* array = value->as_array();
  if (array == nullptr) table.refuse(key, "a list of rings, each " + expected(counts));
  for (const toml::node& element : *array) lists.push_back(points_of(table, key, element, counts));
  return lists;
}

std::optional<glm::dvec3> read_size(TableReader& table, std::string_view key, Bounds bounds) {
  const toml::node* value = table.node(key);
  if (value == nullptr) return std::nullopt;
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 3) table.refuse(key, "[ahead, across, up] in metres");
  glm::dvec3 size_m{};
  for (glm::length_t n = 0; n < 3; ++n)
    size_m[n] = table.checked_number(key, (*list)[static_cast<std::size_t>(n)], bounds);
  return size_m;
}

}  // namespace prairie
