#include "maps/wind_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "maps/decimal.h"
#include "maps/error.h"
#include "maps/input_file.h"

namespace prairie {
namespace {

constexpr std::uint64_t kMaxBytes = 64ull << 20;
constexpr double kMostSpeed = 100.0;
constexpr double kRadiansPerDegree = 0.017453292519943295;

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

/// What stands in a message for a cell that is not a number.
std::string shown(std::string_view cell) {
  constexpr std::size_t kShown = 40;
  if (cell.empty()) return "nothing";
  return fmt::format("\"{}\"", cell.substr(0, kShown));
}

/// Reads the cells of lines by the name of their column.
class Table {
 public:
  Table(std::string_view header, const std::string& name) : name_(name), columns_(cells_of(header)) {}

  std::optional<std::size_t> find(std::string_view column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns_.begin());
  }

  std::size_t need(std::string_view column, const char* expected) const {
    if (const auto found = find(column)) return *found;
    throw BadInput(name_, "line 1", shown(columns_.front()), expected);
  }

  /// The number in a cell that has to be `low` to `high`.
  double number(const std::vector<std::string_view>& cells, std::size_t column, std::size_t line, double low,
                double high) const {
    if (cells.size() != columns_.size()) {
      throw BadInput(name_, fmt::format("line {}", line), fmt::format("{} values", cells.size()),
                     fmt::format("{}, as many as columns", columns_.size()));
    }
    const std::optional<double> value = parse_decimal(cells[column]);
    if (value && *value >= low && *value <= high) return *value;
    refuse(cells, column, line, fmt::format("a number, {} to {}", low, high));
  }

  [[noreturn]] void refuse(const std::vector<std::string_view>& cells, std::size_t column, std::size_t line,
                           const std::string& expected) const {
    throw BadInput(name_, fmt::format("line {}: {}", line, columns_[column]), shown(cells[column]), expected);
  }

 private:
  const std::string& name_;
  std::vector<std::string_view> columns_;
};

}  // namespace

WindFile parse_wind_file(std::string_view text, const std::string& name) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const Table table(taken(text, '\n'), name);
  constexpr const char* kColumns = "columns time_s, speed_m_per_s and heading_rad or direction_deg";
  const std::size_t time = table.need("time_s", kColumns);
  const std::size_t speed = table.need("speed_m_per_s", kColumns);
  const std::optional<std::size_t> heading = table.find("heading_rad");
  const std::size_t direction = heading ? *heading : table.need("direction_deg", kColumns);

  WindFile wind;
  for (std::size_t line = 2; !text.empty(); ++line) {
    const std::string_view row = taken(text, '\n');
    // Only the end of the file may be empty: an empty line between samples is a gap.
    if (trimmed(row).empty() && text.find_first_not_of(" \t\r\n") == std::string_view::npos) break;
    const std::vector<std::string_view> cells = cells_of(row);
    const double time_s = table.number(cells, time, line, -1e12, 1e12);
    if (!wind.times_s.empty() && time_s <= wind.times_s.back()) {
      table.refuse(cells, time, line, fmt::format("a time after {}", wind.times_s.back()));
    }
    wind.times_s.push_back(time_s);
    wind.speeds_m_per_s.push_back(table.number(cells, speed, line, 0.0, kMostSpeed));
    if (heading) {
      wind.headings_rad.push_back(table.number(cells, direction, line, -100.0, 100.0));
    } else {
      wind.headings_rad.push_back((270.0 - table.number(cells, direction, line, -360.0, 720.0)) *
                                  kRadiansPerDegree);
    }
  }
  if (wind.times_s.empty()) throw BadInput(name, "", "no sample", "at least one line of numbers");
  return wind;
}

WindFile read_wind_file(const std::filesystem::path& path) {
  const InputFile file = inspect_input(path, "wind");
  if (file.bytes > kMaxBytes) {
    throw BadInput(path.string(), "", fmt::format("{} bytes", file.bytes),
                   fmt::format("at most {}", kMaxBytes));
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(file.bytes), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) throw BadInput(path.string(), "", "an error while reading", "a file that can be read");
  return parse_wind_file(text, path.string());
}

}  // namespace prairie
