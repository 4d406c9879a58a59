#include "agents/track_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "agents/track_files.h"
#include "files/decimal.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kFarthestFrame = 1e10, kFarthestM = 1e8, kLargestId = 9007199254740992.0;
constexpr std::size_t kShown = 40;
constexpr std::string_view kBetween = " \t\r,;";
constexpr const char* kLayouts =
    "eight numbers a line (UCY obsmat: frame, id, x, z, y and velocities), four (TrajNet: frame, id, x, y) "
    "or five "
    "(Jülich: id, frame, x, y, z); or CSV with columns time_s, id, x_m, y_m";

struct Line {
  std::size_t number = 0;
  std::vector<double> values;
};

struct Table {
  std::vector<std::string> comments;
  std::vector<Line> lines;
};

std::string_view taken_line(std::string_view& rest) {
  const std::size_t length = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return line;
}

std::string_view taken_cell(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
  const std::string_view cell = rest.substr(0, std::min(rest.find_first_of(kBetween), rest.size()));
  rest.remove_prefix(cell.size());
  return cell;
}

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != std::string_view::npos && line[first] == '#';
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(kBetween) == std::string_view::npos;
}

Table read_table(std::string_view rest, const std::string& name) {
  Table table;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    std::string_view text = taken_line(rest);
    if (is_comment(text)) {
      table.comments.emplace_back(text);
      continue;
    }
    if (is_blank(text)) continue;
    check_row_count(table.lines.size() + 1, kMostTrackRows, name);
    Line line{.number = number, .values = {}};
    while (!is_blank(text)) {
      const std::string_view cell = taken_cell(text);
      const std::optional<double> value = parse_decimal(cell);
      if (!value || !std::isfinite(*value)) {
        throw BadInput(name, fmt::format("line {}: column {}", number, line.values.size() + 1),
                       fmt::format("\"{}\"", cell.substr(0, kShown)), "a number");
      }
      line.values.push_back(*value);
      if (line.values.size() > 64) break;
    }
    if (!table.lines.empty() && line.values.size() != table.lines.front().values.size()) {
      throw BadInput(name, fmt::format("line {}", number), fmt::format("{} numbers", line.values.size()),
                     fmt::format("{}, as in the lines before", table.lines.front().values.size()));
    }
    table.lines.push_back(std::move(line));
  }
  return table;
}

/// Which column is which.
struct Columns {
  std::size_t frame, id, x, y;
};

double checked(const Line& line, std::size_t column, const char* what, double most, const std::string& name) {
  const double value = line.values[column];
  const bool must_be_whole = std::string_view(what) == "id";
  if (std::abs(value) <= most && (!must_be_whole || value == std::trunc(value))) return value;
  throw BadInput(name, fmt::format("line {}: {} (column {})", line.number, what, column + 1),
                 fmt::format("\"{:.15g}\"", value),
                 fmt::format("a {}number, {} to {}", must_be_whole ? "whole " : "", -most, most));
}

/// Times are frames still.
std::vector<TrackRow> rows_of(const Table& table, const Columns& columns, const std::string& name) {
  std::vector<TrackRow> rows;
  for (const Line& line : table.lines) {
    TrackRow row;
    row.line = line.number;
    row.time_s = checked(line, columns.frame, "frame", kFarthestFrame, name);
    row.id = static_cast<std::int64_t>(checked(line, columns.id, "id", kLargestId, name));
    row.position_m = {checked(line, columns.x, "x", kFarthestM, name),
                      checked(line, columns.y, "y", kFarthestM, name)};
    rows.push_back(row);
  }
  return rows;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// From a row to the next of the same walker.
struct Step {
  std::size_t from, to;
  double frames;
  double length_m;
};

std::vector<Step> steps_of(const std::vector<TrackRow>& rows) {
  std::map<std::int64_t, std::size_t> last;
  std::vector<Step> steps;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const auto [before, is_new] = last.try_emplace(rows[n].id, n);
    if (is_new) continue;
    const TrackRow& from = rows[before->second];
    if (rows[n].time_s > from.time_s)
      steps.push_back({before->second, n, rows[n].time_s - from.time_s,
                       glm::distance(rows[n].position_m, from.position_m)});
    before->second = n;
  }
  return steps;
}

/// Of all steps that lead anywhere, metres a frame; 0 where none does.
double metres_per_frame(const std::vector<TrackRow>& rows) {
  std::vector<double> speeds;
  for (const Step& step : steps_of(rows)) {
    if (step.length_m > 0.0) speeds.push_back(step.length_m / step.frames);
  }
  return speeds.empty() ? 0.0 : median(std::move(speeds));
}

/// The rate of all that come into question that makes a median walk of it.
double likeliest_rate(double metres_a_frame, std::span<const double> rates) {
  constexpr double kUsualWalkMPerS = 1.34;  // Weidmann 1993
  double best = rates[0];
  if (!(metres_a_frame > 0.0)) return best;
  for (const double rate : rates) {
    const auto off = [&](double r) { return std::abs(std::log(metres_a_frame * r / kUsualWalkMPerS)); };
    if (off(rate) < off(best)) best = rate;
  }
  return best;
}

void set_times(TrackRecording& recording, double frames_per_s) {
  for (TrackRow& row : recording.rows) row.time_s /= frames_per_s;
}

/// Of an obsmat, by its own velocities; nothing where they do not go with the places.
std::optional<double> rate_by_velocities(const Table& table, const std::vector<TrackRow>& rows) {
  std::vector<double> rates;
  for (const Step& step : steps_of(rows)) {
    const auto speed = [&](std::size_t n) {
      return std::hypot(table.lines[n].values[5], table.lines[n].values[7]);
    };
    const double m_per_s = 0.5 * (speed(step.from) + speed(step.to));
    constexpr double kLeastSpeed = 0.2;  // standing people tell nothing
    if (m_per_s > kLeastSpeed && step.length_m > 0.0) rates.push_back(m_per_s * step.frames / step.length_m);
  }
  constexpr std::size_t kEnough = 5;
  if (rates.size() < kEnough) return std::nullopt;
  const double middle = median(rates);
  const auto near =
      std::ranges::count_if(rates, [&](double r) { return std::abs(r - middle) < 0.1 * middle; });
  if (near * 2 < static_cast<std::ptrdiff_t>(rates.size())) return std::nullopt;
  constexpr std::array kUsualRates{2.5, 10.0, 12.5, 15.0, 16.0, 20.0, 24.0, 25.0, 30.0, 50.0, 60.0};
  for (const double usual : kUsualRates) {
    if (std::abs(middle - usual) < 0.03 * usual) return usual;
  }
  return middle;
}

TrackRecording read_obsmat(const Table& table, const std::string& name, std::optional<double> frames_per_s) {
  TrackRecording recording;
  recording.rows = rows_of(table, {.frame = 0, .id = 1, .x = 2, .y = 4}, name);
  double rate = frames_per_s.value_or(kUsualFramesPerS);
  if (!frames_per_s) {
    if (const auto told = rate_by_velocities(table, recording.rows)) rate = *told;
    if (rate != kUsualFramesPerS)
      recording.notes.push_back(fmt::format("{:.4g} frames a second, by the file's own velocities", rate));
  }
  set_times(recording, rate);
  return recording;
}

TrackRecording read_trajnet(const Table& table, const std::string& name, std::optional<double> frames_per_s) {
  TrackRecording recording;
  const std::vector<TrackRow> frames_first = rows_of(table, {.frame = 0, .id = 1, .x = 2, .y = 3}, name);
  const bool ids_may_be_first = std::ranges::all_of(
      table.lines, [](const Line& line) { return line.values[0] == std::trunc(line.values[0]); });
  recording.rows = frames_first;
  if (ids_may_be_first) {
    std::vector<TrackRow> ids_first = rows_of(table, {.frame = 1, .id = 0, .x = 2, .y = 3}, name);
    // Whoever is one walker does not jump about.
    const double a = metres_per_frame(frames_first), b = metres_per_frame(ids_first);
    const auto steps = [](const std::vector<TrackRow>& rows) { return steps_of(rows).size(); };
    const bool is_likelier =
        b > 0.0 && (a == 0.0 || b < 0.2 * a) && steps(ids_first) >= steps(frames_first) / 2;
    if (is_likelier) {
      recording.rows = std::move(ids_first);
      recording.notes.emplace_back("read as id, frame, x, y");
    }
  }
  constexpr std::array kRates{kUsualFramesPerS, 2.5, 10.0, 30.0};
  const double pace = metres_per_frame(recording.rows);
  const double at_usual = pace * kUsualFramesPerS;
  const bool is_usual = at_usual == 0.0 || (at_usual > 0.4 && at_usual < 2.5);
  const double rate = frames_per_s.value_or(is_usual ? kUsualFramesPerS : likeliest_rate(pace, kRates));
  if (!frames_per_s) {
    recording.notes.push_back(fmt::format(
        "read as TrajNet, {:.4g} frames a second: a median speed of {:.2f} m/s; --replay-fps says otherwise",
        rate, pace * rate));
  }
  set_times(recording, rate);
  return recording;
}

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "# framerate: 25.00 fps"
std::optional<double> rate_in(const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) {
    const std::string text = lowered(comment);
    const std::size_t at = text.find("framerate");
    if (at == std::string::npos) continue;
    std::string_view rest = std::string_view(text).substr(at + std::string_view("framerate").size());
    rest.remove_prefix(std::min(rest.find_first_of("0123456789"), rest.size()));
    const std::string_view number =
        rest.substr(0, std::min(rest.find_first_not_of("0123456789."), rest.size()));
    if (const auto rate = parse_decimal(number); rate && *rate > 0.0 && *rate < 1e4) return rate;
  }
  return std::nullopt;
}

/// Whether comments or, failing these, the people's heights tell of centimetres.
bool is_in_centimetres(const Table& table, double metres_a_frame, double rate) {
  for (const std::string& comment : table.comments) {
    const std::string text = lowered(comment);
    if (text.find("/cm") != std::string::npos || text.find("in cm") != std::string::npos) return true;
    if (text.find("/m") != std::string::npos || text.find("in m") != std::string::npos) return false;
  }
  std::vector<double> heights;
  for (const Line& line : table.lines) heights.push_back(std::abs(line.values[4]));
  const double height = median(std::move(heights));
  constexpr double kTallestM = 3.0, kLeastM = 0.3;
  if (height > kLeastM && height < kTallestM) return false;
  if (height > 100.0 * kLeastM && height < 100.0 * kTallestM) return true;
  return metres_a_frame * rate > kMostMedianSpeedMPerS;
}

TrackRecording read_juelich(const Table& table, const std::string& name, std::optional<double> frames_per_s) {
  TrackRecording recording;
  recording.rows = rows_of(table, {.frame = 1, .id = 0, .x = 2, .y = 3}, name);
  const std::optional<double> told = frames_per_s ? frames_per_s : rate_in(table.comments);
  const double pace = metres_per_frame(recording.rows);
  constexpr std::array kRates{16.0, kUsualFramesPerS};
  const double unit_m = is_in_centimetres(table, pace, told.value_or(kRates[0])) ? 0.01 : 1.0;
  const double rate = told.value_or(likeliest_rate(unit_m * pace, kRates));
  for (TrackRow& row : recording.rows) row.position_m *= unit_m;
  recording.notes.push_back(fmt::format("read as id, frame, x, y, z in {}, {:.4g} frames a second{}",
                                        unit_m < 1.0 ? "centimetres" : "metres", rate,
                                        told ? "" : " by the speed; --replay-fps says otherwise"));
  set_times(recording, rate);
  return recording;
}

}  // namespace

void check_row_count(std::size_t rows, std::size_t most, const std::string& name) {
  if (rows > most) throw BadInput(name, "", fmt::format("more than {} rows", most), "at most as many");
}

bool is_track_table(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = taken_line(text);
    if (is_comment(line) || is_blank(line)) continue;
    while (!is_blank(line)) {
      if (!parse_decimal(taken_cell(line))) return false;
    }
    return true;
  }
  return false;
}

TrackRecording read_track_table(std::string_view text, const std::string& name,
                                std::optional<double> frames_per_s) {
  const Table table = read_table(text, name);
  const std::size_t columns = table.lines.empty() ? 0 : table.lines.front().values.size();
  switch (columns) {
    case 8:
      return read_obsmat(table, name, frames_per_s);
    case 4:
      return read_trajnet(table, name, frames_per_s);
    case 5:
      return read_juelich(table, name, frames_per_s);
    default:
      throw BadInput(name, table.lines.empty() ? "" : fmt::format("line {}", table.lines.front().number),
                     fmt::format("{} numbers", columns), kLayouts);
  }
}

}  // namespace prairie
