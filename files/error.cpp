#include "files/error.h"

#include <utility>

namespace prairie {
namespace {

std::string joined(const std::string& file, const std::string& field, const std::string& found,
                   const std::string& expected) {
  std::string line;
  const auto add = [&line](const char* separator, const char* lead, const std::string& part) {
    if (part.empty()) return;
    if (!line.empty()) line += separator;
    line += lead;
    line += part;
  };
  add("", "", file);
  add(": ", "", field);
  add(": ", "found ", found);
  add(found.empty() ? ": " : ", ", "expected ", expected);
  // File names and the texts of foreign libraries may hold line breaks; a message is one line.
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace

Fault::Fault(std::string in_file, std::string in_field, std::string in_found, std::string in_expected)
    : std::runtime_error(joined(in_file, in_field, in_found, in_expected)),
      file(std::move(in_file)),
      field(std::move(in_field)),
      found(std::move(in_found)),
      expected(std::move(in_expected)) {}

}  // namespace prairie
