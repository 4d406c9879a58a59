// A measured wind as comma-separated text: a line of column names, then a line per sample.
//
// Columns, in any order, others are passed over: `time_s`, rising; `speed_m_per_s`; and either `heading_rad`,
// towards which it blows, from east, counter-clockwise, or `direction_deg`, as weather stations have it: from
// which it blows, from north, clockwise.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace prairie {

/// One entry of each per sample.
struct WindFile {
  std::vector<double> times_s;
  std::vector<double> speeds_m_per_s;  // 0…100
  std::vector<double> headings_rad;    // as above, whichever column the file has
};

/// Throws BadInput that names line, column, what was found and what was expected. `name`: of the file, for
/// messages.
WindFile parse_wind_file(std::string_view text, const std::string& name);

/// Throws BadInput, also where the file cannot be read or is larger than 64 MiB.
WindFile read_wind_file(const std::filesystem::path& path);

}  // namespace prairie
