#include "world/scene/key_table.h"

#include <algorithm>

namespace prairie {

std::vector<std::size_t> hash_order(const std::vector<HashLine>& lines) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < lines.size(); ++place) {
    if (!lines[place].name.empty()) places.push_back(place);
  }
  std::ranges::stable_sort(places, {}, [&](std::size_t place) { return lines[place].rank; });
  return places;
}

}  // namespace prairie
