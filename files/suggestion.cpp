#include "files/suggestion.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace prairie {
namespace {

// Longer words than this are no typing errors of a key, and the distance costs the product of the lengths.
constexpr std::size_t kLongestWord = 64;

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

std::size_t alignment_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

bool lacks_only_the_unit(std::string_view word, std::string_view known) {
  constexpr std::string_view kUnits[] = {"_m", "_mm", "_deg", "_g", "_per_m", "_per_m2"};
  return word.size() >= 3 && known.starts_with(word) &&
         std::find(std::begin(kUnits), std::end(kUnits), known.substr(word.size())) != std::end(kUnits);
}

}  // namespace

std::optional<std::string> suggestion(std::string_view word, std::span<const std::string> known) {
  if (word.empty() || word.size() > kLongestWord) return std::nullopt;
  const std::string lower = lower_case(word);
  const std::size_t farthest = std::max<std::size_t>(1, word.size() / 3);
  std::optional<std::string> nearest;
  std::size_t nearest_distance = farthest + 1;
  for (const std::string& candidate : known) {
    const std::string lower_candidate = lower_case(candidate);
    const std::size_t distance =
        lacks_only_the_unit(lower, lower_candidate) ? 1 : alignment_distance(lower, lower_candidate);
    if (distance < nearest_distance) {
      nearest = candidate;
      nearest_distance = distance;
    }
  }
  return nearest;
}

}  // namespace prairie
