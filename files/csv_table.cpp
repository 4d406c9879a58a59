#include "files/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "files/decimal.h"
#include "files/error.h"
#include "files/input_file.h"

namespace prairie {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\"";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Takes the text up to the separator, and both away from `rest`.
std::string_view taken(std::string_view& rest, char separator) {
  const std::size_t length = std::min(rest.find(separator), rest.size());
  const std::string_view part = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return part;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  const std::size_t count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
  while (cells.size() < count) cells.push_back(trimmed(taken(line, ',')));
  return cells;
}

/// What stands in a message for a cell that is not as it should be.
std::string shown(std::string_view cell) {
  constexpr std::size_t kShown = 40;
  if (cell.empty()) return "nothing";
  return fmt::format("\"{}\"", cell.substr(0, kShown));
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string name) : name_(std::move(name)), rest_(text) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  columns_ = cells_of(taken(rest_, '\n'));
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvTable::need(std::string_view column, const std::string& expected) const {
  if (const auto found = find(column)) return *found;
  throw BadInput(name_, "line 1", shown(columns_.front()), expected);
}

bool CsvTable::next_row() {
  // Only the end of the file may be empty: an empty line between rows is a gap.
  if (rest_.find_first_not_of(" \t\r\n\"") == std::string_view::npos) return false;
  ++line_;
  cells_ = cells_of(taken(rest_, '\n'));
  if (cells_.size() != columns_.size()) {
    throw BadInput(name_, fmt::format("line {}", line_), fmt::format("{} values", cells_.size()),
                   fmt::format("{}, as many as columns", columns_.size()));
  }
  return true;
}

double CsvTable::number(std::size_t column, double low, double high) const {
  const std::optional<double> value = parse_decimal(cells_[column]);
  if (value && *value >= low && *value <= high) return *value;
  refuse(column, fmt::format("a number, {} to {}", low, high));
}

void CsvTable::refuse(std::size_t column, const std::string& expected) const {
  throw BadInput(name_, fmt::format("line {}: {}", line_, columns_[column]), shown(cells_[column]), expected);
}

std::string read_text_input(const std::filesystem::path& path, const std::string& field,
                            std::size_t most_bytes) {
  const InputFile file = inspect_input(path, field);
  if (file.bytes > most_bytes) {
    throw BadInput(path.string(), "", fmt::format("{} bytes", file.bytes),
                   fmt::format("at most {}", most_bytes));
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(file.bytes), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) throw BadInput(path.string(), "", "an error while reading", "a file that can be read");
  return text;
}

}  // namespace prairie
