#include "tests/house/source_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace prairie {
namespace {

constexpr std::array<std::string_view, 4> kShaderSuffixes{".glsl", ".vert", ".frag", ".comp"};

bool is_source(const std::filesystem::path& path) {
  const std::string suffix = path.extension().string();
  return suffix == ".h" || suffix == ".cpp" ||
         std::ranges::find(kShaderSuffixes, suffix) != kShaderSuffixes.end();
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Blanks what is no code, going on from line to line.
class CodeReader {
 public:
  std::string code(std::string line) {
    std::size_t at = 0;
    while (at < line.size()) at = step(line, at);
    return line;
  }

 private:
  /// Blanks up to `end`.
  static std::size_t blank(std::string& line, std::size_t from, std::size_t end) {
    end = std::min(end, line.size());
    std::fill(line.begin() + static_cast<std::ptrdiff_t>(from),
              line.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    return end;
  }
  static std::size_t behind(const std::string& line, std::string_view text, std::size_t from) {
    const std::size_t found = line.find(text, from);
    return found == std::string::npos ? std::string::npos : found + text.size();
  }

  std::size_t step(std::string& line, std::size_t at) {
    if (!awaited_.empty()) {
      const std::size_t end = behind(line, awaited_, at);
      if (end != std::string::npos) awaited_.clear();
      return blank(line, at, end);
    }
    if (line.compare(at, 2, "//") == 0) return blank(line, at, std::string::npos);
    if (line.compare(at, 2, "/*") == 0) {
      awaited_ = "*/";
      return blank(line, at, at + 2);
    }
    if (line.compare(at, 2, "R\"") == 0) {
      const std::size_t open = line.find('(', at);
      awaited_ = fmt::format("){}\"", line.substr(at + 2, open - at - 2));
      return blank(line, at, open + 1);
    }
    const bool is_digit_separator =
        line[at] == '\'' && at > 0 && std::isalnum(static_cast<unsigned char>(line[at - 1]));
    if (line[at] == '"' || (line[at] == '\'' && !is_digit_separator))
      return blank(line, at, end_of_literal(line, at));
    return at + 1;
  }
  static std::size_t end_of_literal(const std::string& line, std::size_t at) {
    const char quote = line[at];
    for (++at; at < line.size() && line[at] != quote; ++at) {
      if (line[at] == '\\') ++at;
    }
    return at + 1;
  }

  std::string awaited_;  // what ends the comment or raw string that goes on
};

/// A block that others may stand in: namespaces and types, not functions.
bool opens_scope(const std::string& head) {
  constexpr std::array<std::string_view, 6> kWords{"namespace", "class", "struct", "union", "enum", "extern"};
  const std::size_t first = head.find_first_not_of(' ');
  if (first == std::string::npos) return true;
  std::string_view text = std::string_view(head).substr(first);
  if (text.starts_with("template")) return head.find('(') == std::string::npos;
  return std::ranges::any_of(kWords, [&](std::string_view word) { return text.starts_with(word); }) &&
         head.find(") {") == std::string::npos;
}

}  // namespace

bool SourceFile::is_shader() const {
  return std::ranges::any_of(kShaderSuffixes,
                             [&](std::string_view suffix) { return path.ends_with(suffix); });
}

std::vector<SourceFile> source_files(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (auto entry = std::filesystem::recursive_directory_iterator(root);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name.starts_with('.') || name == "build" || name == "out"))
      entry.disable_recursion_pending();
    if (entry->is_regular_file() && is_source(entry->path()))
      files.push_back(
          {std::filesystem::relative(entry->path(), root).generic_string(), lines_of(entry->path())});
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::string> rooms(const std::filesystem::path& root) {
  return lines_of(root / "cmake/rooms.txt");
}

std::string room_of(const std::string& path, const std::vector<std::string>& rooms) {
  std::string longest;
  for (const std::string& room : rooms) {
    if (path.starts_with(room + "/") && room.size() > longest.size()) longest = room;
  }
  return longest;
}

std::vector<Include> includes_of(const SourceFile& file) {
  constexpr std::string_view kWord = "#include ";
  std::vector<Include> includes;
  for (std::size_t n = 0; n < file.lines.size(); ++n) {
    const std::string& line = file.lines[n];
    if (!line.starts_with(kWord) || line.size() < kWord.size() + 2) continue;
    const bool is_of_house = line[kWord.size()] == '"';
    const std::size_t end = line.find(is_of_house ? '"' : '>', kWord.size() + 1);
    includes.push_back({line.substr(kWord.size() + 1, end - kWord.size() - 1), is_of_house, n + 1});
  }
  return includes;
}

std::vector<std::string> code_of(const SourceFile& file) {
  CodeReader reader;
  std::vector<std::string> code;
  for (const std::string& line : file.lines) code.push_back(reader.code(line));
  return code;
}

std::vector<Function> functions_of(const SourceFile& file) {
  std::vector<Function> functions;
  int scopes = 0;         // that are open around functions
  int inside = 0;         // braces open within a function
  std::string head;       // of what may become one
  std::size_t first = 0;  // its line
  const std::vector<std::string> code = code_of(file);
  for (std::size_t n = 0; n < code.size(); ++n) {
    if (inside == 0 && code[n].starts_with('#')) continue;
    for (const char c : code[n]) {
      if (inside > 0) {
        inside += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (inside == 0 && c == '}') {
          if (head.find('(') != std::string::npos) functions.push_back({first + 1, n - first + 1});
          head.clear();
        }
      } else if (c == '{') {
        if (opens_scope(head + " {")) {
          ++scopes;
          head.clear();
        } else {
          inside = 1;
        }
      } else if (c == '}') {
        --scopes;
        head.clear();
      } else if (c == ';') {
        head.clear();
      } else {
        if (head.find_first_not_of(' ') == std::string::npos && c != ' ') first = n;
        head += c;
      }
    }
    if (inside == 0) head += ' ';
  }
  return functions;
}

}  // namespace prairie
