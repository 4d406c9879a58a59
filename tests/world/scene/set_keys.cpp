#include "tests/world/scene/set_keys.h"

#include <fmt/format.h>

#include <map>
#include <sstream>

namespace prairie::testing {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<SetKey> set_keys(const std::string& text) {
  std::vector<SetKey> keys;
  std::map<std::string, int> several;
  std::string section, path;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const std::string& line = lines[n];
    const auto equals = line.find(" = ");
    if (line.starts_with("[[")) {
      section = line.substr(2, line.size() - 4);
      path = fmt::format("{}.{}.", section, several[section]++);
    } else if (line.starts_with("[")) {
      section = line.substr(1, line.size() - 2);
      const bool is_density = section == "species.density";
      path = is_density ? fmt::format("species.{}.density.", several["species"] - 1) : section + ".";
    } else if (equals != std::string::npos) {
      const std::string key = line.substr(0, equals);
      keys.push_back({section, key, path + key, line.substr(equals + 3), n});
    }
  }
  return keys;
}

std::string without_line(const std::string& text, std::size_t line) {
  std::string rest;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t n = 0; n < lines.size(); ++n) {
    if (n != line) rest += lines[n] + '\n';
  }
  return rest;
}

}  // namespace prairie::testing
