#include "maps/wind_file.h"

#include <fmt/format.h>

#include <optional>

#include "files/csv_table.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr double kMostSpeed = 100.0;
constexpr double kRadiansPerDegree = 0.017453292519943295;

}  // namespace

WindFile parse_wind_file(std::string_view text, const std::string& name) {
  CsvTable table(text, name);
  constexpr const char* kColumns = "columns time_s, speed_m_per_s and heading_rad or direction_deg";
  const std::size_t time = table.need("time_s", kColumns);
  const std::size_t speed = table.need("speed_m_per_s", kColumns);
  const std::optional<std::size_t> heading = table.find("heading_rad");
  const std::size_t direction = heading ? *heading : table.need("direction_deg", kColumns);

  WindFile wind;
  while (table.next_row()) {
    const double time_s = table.number(time, -1e12, 1e12);
    if (!wind.times_s.empty() && time_s <= wind.times_s.back())
      table.refuse(time, fmt::format("a time after {}", wind.times_s.back()));
    wind.times_s.push_back(time_s);
    wind.speeds_m_per_s.push_back(table.number(speed, 0.0, kMostSpeed));
    wind.headings_rad.push_back(heading
                                    ? table.number(direction, -100.0, 100.0)
                                    : (270.0 - table.number(direction, -360.0, 720.0)) * kRadiansPerDegree);
  }
  if (wind.times_s.empty()) throw BadInput(name, "", "no sample", "at least one line of numbers");
  return wind;
}

WindFile read_wind_file(const std::filesystem::path& path) {
  return parse_wind_file(read_text_input(path, "wind", kMostBytes), path.string());
}

}  // namespace prairie
