#include "agents/gpx_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <pugixml.hpp>

#include "files/decimal.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kShown = 40;

/// Counts lines while places in the text come in rising order.
class LineCount {
 public:
  explicit LineCount(std::string_view text) : text_(text) {}

  /// The line of a byte; `offset` is negative where it is not known.
  std::size_t at(std::ptrdiff_t offset) {
    const std::size_t until = offset < 0 ? place_ : std::min(static_cast<std::size_t>(offset), text_.size());
    if (until > place_) {
      line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(place_),
                                                   text_.begin() + static_cast<std::ptrdiff_t>(until), '\n'));
      place_ = until;
    }
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t place_ = 0, line_ = 1;
};

std::string shown(std::string_view text) {
  if (text.empty()) return "nothing";
  return fmt::format("\"{}\"", text.substr(0, kShown));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Takes so many digits away from the front of `text`.
std::optional<int> taken_number(std::string_view& text, std::size_t digits) {
  if (text.size() < digits) return std::nullopt;
  int number = 0;
  for (const char c : text.substr(0, digits)) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  text.remove_prefix(digits);
  return number;
}

bool taken(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

/// Takes a fraction of a second away, if there is one.
std::optional<double> taken_fraction(std::string_view& text) {
  if (!text.starts_with('.') && !text.starts_with(',')) return 0.0;
  text.remove_prefix(1);
  double fraction = 0.0, digit = 0.1;
  const std::size_t before = text.size();
  for (; !text.empty() && text[0] >= '0' && text[0] <= '9'; text.remove_prefix(1), digit *= 0.1)
    fraction += digit * (text[0] - '0');
  if (text.size() == before) return std::nullopt;
  return fraction;
}

/// What is to be added to reach UTC; takes the rest of the text.
std::optional<double> taken_zone_s(std::string_view text) {
  if (text.empty() || text == "Z" || text == "z") return 0.0;
  const bool east = text[0] == '+';
  if (!east && text[0] != '-') return std::nullopt;
  text.remove_prefix(1);
  const std::optional<int> hours = taken_number(text, 2);
  if (!text.empty()) taken(text, ':');
  const std::optional<int> minutes = text.empty() ? 0 : taken_number(text, 2);
  if (!hours || !minutes || !text.empty() || *hours > 14 || *minutes > 59) return std::nullopt;
  const double offset_s = 3600.0 * *hours + 60.0 * *minutes;
  return east ? -offset_s : offset_s;
}

double read_degrees(const pugi::xml_node& point, const char* key, double most, const std::string& name,
                    std::size_t line) {
  const std::string_view text = point.attribute(key).value();
  const std::optional<double> degrees = parse_decimal(text);
  if (degrees && *degrees >= -most && *degrees <= most) return *degrees;
  throw BadInput(name, fmt::format("line {}: {}", line, key), shown(text),
                 fmt::format("degrees, {} to {}", -most, most));
}

GpxPoint read_point(const pugi::xml_node& node, const std::string& name, std::size_t line) {
  GpxPoint point;
  point.line = line;
  point.at = {read_degrees(node, "lat", 90.0, name, line), read_degrees(node, "lon", 180.0, name, line)};
  if (const pugi::xml_node time = node.child("time")) {
    const std::string_view text = time.child_value();
    point.time_s = parse_gpx_time(text);
    if (!point.time_s) {
      throw BadInput(name, fmt::format("line {}: time", line), shown(trimmed(text)),
                     "a time such as 2010-08-05T14:23:59Z");
    }
  }
  return point;
}

}  // namespace

std::optional<double> parse_gpx_time(std::string_view text) {
  text = trimmed(text);
  const std::optional<int> year = taken_number(text, 4);
  const bool dash = taken(text, '-');
  const std::optional<int> month = taken_number(text, 2);
  const bool dash_again = taken(text, '-');
  const std::optional<int> day = taken_number(text, 2);
  const bool t = taken(text, 'T') || taken(text, ' ');
  const std::optional<int> hour = taken_number(text, 2);
  const bool colon = taken(text, ':');
  const std::optional<int> minute = taken_number(text, 2);
  const bool colon_again = taken(text, ':');
  const std::optional<int> second = taken_number(text, 2);
  if (!year || !dash || !month || !dash_again || !day || !t || !hour || !colon || !minute || !colon_again ||
      !second)
    return std::nullopt;
  const std::optional<double> fraction_s = taken_fraction(text);
  const std::optional<double> zone_s = taken_zone_s(text);
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!fraction_s || !zone_s || !date.ok() || *hour > 23 || *minute > 59 || *second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * *hour + 60.0 * *minute + *second + *fraction_s +
         *zone_s;
}

std::vector<std::vector<GpxPoint>> parse_gpx(std::string_view text, const std::string& name) {
  if (text.size() > kMostGpxBytes) {
    throw BadInput(name, "", fmt::format("{} bytes", text.size()),
                   fmt::format("at most {} of GPX", kMostGpxBytes));
  }
  LineCount lines(text);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) {
    throw BadInput(name, fmt::format("line {}", lines.at(result.offset)), result.description(),
                   "a GPX file, which is XML");
  }
  const pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "gpx")
    throw BadInput(name, "line 1", fmt::format("<{}>", std::string_view(root.name()).substr(0, kShown)),
                   "<gpx>");
  std::vector<std::vector<GpxPoint>> segments;
  for (const pugi::xml_node& track : root.children("trk")) {
    for (const pugi::xml_node& segment : track.children("trkseg")) {
      segments.emplace_back();
      for (const pugi::xml_node& point : segment.children("trkpt"))
        segments.back().push_back(read_point(point, name, lines.at(point.offset_debug())));
    }
  }
  return segments;
}

}  // namespace prairie
