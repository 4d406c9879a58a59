// The keys that a scene's text sets, one to a line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace prairie::testing {

struct SetKey {
  std::string section;  // as its tables are called: species, wind.gust
  std::string key;
  std::string path;   // for overrides: species.0.height_m
  std::string value;  // TOML
  std::size_t line;   // from 0
};

std::vector<SetKey> set_keys(const std::string& text);

/// The text without one of its lines.
std::string without_line(const std::string& text, std::size_t line);

}  // namespace prairie::testing
