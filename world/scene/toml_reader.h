// A checked view of a TOML table: every value has the right type and lies in range, every key is one that was
// asked for, or BadInput names the file, the dotted key, the line, what was found and what was expected, in
// one line of text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// toml++ itself takes a second to parse: only files that look into its nodes include it.
namespace toml {
inline namespace v3 {
class node;
class table;
}  // namespace v3
}  // namespace toml

namespace prairie {

/// Closed interval that a number must lie in.
struct Bounds {
  double min = 0.0;
  double max = 0.0;
};

/// Where a table came from, for messages.
struct TomlOrigin {
  std::string file;
  bool has_lines = true;  // false where parts of the table were put together from other sources
};

class TableReader {
 public:
  /// `path` is the table's dotted key, empty for the whole file. The table must outlive the reader.
  TableReader(TomlOrigin origin, std::string path, const toml::table& table);

  // Each of these returns nothing where the key is absent, and makes the key a known one.
  std::optional<double> number(std::string_view key, Bounds bounds);
  /// Whatever its value, also one that is not finite: for numbers that another check judges.
  std::optional<double> any_number(std::string_view key);
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t min, std::int64_t max);
  std::optional<bool> flag(std::string_view key);
  std::optional<std::string> text(std::string_view key);
  /// One of the words, by its place among them.
  std::optional<std::size_t> choice(std::string_view key, const std::vector<std::string>& words);
  std::optional<std::array<double, 2>> pair(std::string_view key, Bounds bounds);
  /// "#rrggbb" (sRGB) or [r, g, b] (linear); linear out.
  std::optional<glm::vec3> color(std::string_view key, Bounds bounds);
  std::optional<TableReader> table(std::string_view key);
  /// The elements of an array of tables ([[key]]), in the file's order; empty where the key is absent.
  std::vector<TableReader> tables(std::string_view key);
  /// The value as it stands, for keys that may be of several types; null where absent.
  const toml::node* node(std::string_view key);
  /// These do not make the key a known one.
  bool has(std::string_view key) const;
  bool holds_table(std::string_view key) const;
  bool holds_number(std::string_view key) const;
  double checked_number(std::string_view key, const toml::node& value, Bounds bounds) const;

  /// Throws BadInput if the table has a key that nobody asked for; call it after the last question.
  void refuse_unknown_keys() const;

  /// Throws BadInput about a required key that is absent; where an unknown key looks like it, about that one.
  [[noreturn]] void refuse_missing(std::string_view key, std::string_view expected) const;
  /// Throws BadInput about a key that is there.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;
  [[noreturn]] void refuse(std::string_view key, const std::string& found, const std::string& expected) const;

  /// Dotted key of one of the table's own keys.
  std::string path_of(std::string_view key) const;

 private:
  std::optional<std::string> first_unknown_key() const;
  [[noreturn]] void refuse_unknown(const std::string& key) const;

  TomlOrigin origin_;
  std::string path_;
  const toml::table* table_;
  std::vector<std::string> known_;
};

/// Control characters replaced and long text cut, so that a message stays one readable line.
std::string printable(std::string_view text, std::size_t longest = 60);

}  // namespace prairie
