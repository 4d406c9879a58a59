// The project's own sources, as text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prairie {

struct SourceFile {
  std::string path;                // from the sources' root, such as "lod/planner.cpp"
  std::vector<std::string> lines;  // without line ends

  bool is_shader() const;  // GLSL
  bool is_test() const { return path.starts_with("tests/"); }
};

/// All C++ and GLSL below `root`, but for what is built there; by path.
std::vector<SourceFile> source_files(const std::filesystem::path& root);

/// The folders of cmake/rooms.txt, from the lowest.
std::vector<std::string> rooms(const std::filesystem::path& root);

/// The room that a file lies in: the longest that its path begins with; empty where there is none.
std::string room_of(const std::string& path, const std::vector<std::string>& rooms);

struct Include {
  std::string path;          // as it is written
  bool is_of_house = false;  // in quotes
  std::size_t line = 0;      // from 1
};
std::vector<Include> includes_of(const SourceFile& file);

/// The lines without comments, string and character literals, which are blanked.
std::vector<std::string> code_of(const SourceFile& file);

struct Function {
  std::size_t line = 0;   // of its first one, from 1
  std::size_t lines = 0;  // from there to its closing brace
};
/// Functions outside of others, as clang-format lays them out.
std::vector<Function> functions_of(const SourceFile& file);

}  // namespace prairie
