#include "world/point_list.h"

#include <fmt/format.h>

namespace prairie {
namespace {

constexpr Bounds kPositionM{-1e6, 1e6};

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

std::vector<glm::dvec2> read_points(TableReader& table, std::string_view key, PointCounts counts) {
  const toml::node* value = table.node(key);
  if (value == nullptr) table.refuse_missing(key, expected(counts));
  return points_of(table, key, *value, counts);
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

glm::dvec2 need_place(TableReader& table, std::string_view key) {
  const auto place_m = table.pair(key, kPositionM);
  if (!place_m) table.refuse_missing(key, "a place [x, y] in metres");
  return {(*place_m)[0], (*place_m)[1]};
}

}  // namespace prairie
