// What files of tracks say, line by line, whatever their layout; agents/track_files.h makes tracks of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace prairie {

/// One walker at one time, as a line of the file says it.
struct TrackRow {
  std::int64_t id = 0;
  std::size_t line = 0;
  double time_s = 0.0;
  glm::dvec2 position_m{0.0};
  bool goes_on = false;  // from the row before, however long that took
};

/// What the formats differ in once their rows are read.
struct TrackRecording {
  std::vector<TrackRow> rows;
  double longest_gap_s = 5.0;
  bool leaves_out_repeated =
      false;  // times of clocks that stand still or are set back; else they are refused
  bool is_on_earth = false;
  std::string if_too_fast = ": positions look like centimetres, where metres are expected";
  std::vector<std::string> notes;  // what was guessed or left out
};

/// Throws BadInput where a file has more rows than `most`.
void check_row_count(std::size_t rows, std::size_t most, const std::string& name);

}  // namespace prairie
