// Comma-separated numbers as text: a line of column names, then a line of cells each row. Columns may come in
// any order, blanks and quotes around cells and a byte order mark before them are passed over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prairie {

/// Goes through the rows of a table. What is wrong is thrown as BadInput that names line and column.
class CsvTable {
 public:
  /// Reads the line of names. `text` has to live as long as the table; `name`: of the file, for messages.
  CsvTable(std::string_view text, std::string name);

  std::optional<std::size_t> find(std::string_view column) const;
  /// The column; where it is missing the message says that `expected` was.
  std::size_t need(std::string_view column, const std::string& expected) const;

  /// Steps to the next row; false after the last. A row has as many cells as there are columns, an empty line
  /// none.
  bool next_row();
  std::string_view cell(std::size_t column) const { return cells_[column]; }
  /// The number in a cell of this row, which has to be `low` to `high`.
  double number(std::size_t column, double low, double high) const;
  [[noreturn]] void refuse(std::size_t column, const std::string& expected) const;

 private:
  std::string name_;
  std::string_view rest_;
  std::vector<std::string_view> columns_;
  std::vector<std::string_view> cells_;
  std::size_t line_ = 1;
};

/// The text of a person's file; `field` names what asked for it. Throws BadInput where it cannot be read or
/// is larger than `most_bytes`.
std::string read_text_input(const std::filesystem::path& path, const std::string& field,
                            std::size_t most_bytes);

}  // namespace prairie
