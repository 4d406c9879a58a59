// The house as its plan says (docs/design.md): which room may use which, how large files and functions are,
// and that what is to stand once stands once.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "tests/house/source_tree.h"

namespace prairie {
namespace {

constexpr std::size_t kMostLinesOfFile = 450;
constexpr std::size_t kMostLinesOfFunction = 80;
constexpr std::size_t kMostColumns = 110;

const std::filesystem::path kRoot = PRAIRIE_SOURCES;

const std::vector<SourceFile>& all_files() {
  static const std::vector<SourceFile> files = source_files(kRoot);
  return files;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

TEST(HouseTest, NoIncludeRunsUp) {
  const std::vector<std::string> order = rooms(kRoot);
  const auto floor_of = [&](const std::string& path) {
    return std::ranges::find(order, room_of(path, order)) - order.begin();
  };
  std::size_t checked = 0;
  for (const SourceFile& file : all_files()) {
    if (file.is_test() || file.path.starts_with("cmake/")) continue;
    ASSERT_NE(room_of(file.path, order), "") << file.path << " lies in no room of cmake/rooms.txt";
    for (const Include& include : includes_of(file)) {
      if (!include.is_of_house) continue;
      EXPECT_NE(room_of(include.path, order), "")
          << file.path << ':' << include.line << " includes " << include.path << ", not from the root";
      EXPECT_LE(floor_of(include.path), floor_of(file.path))
          << file.path << ':' << include.line << " includes " << include.path << " from a room above";
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000u);
}

TEST(HouseTest, NoFilesIncludeOneAnotherInACircle) {
  std::map<std::string, std::vector<std::string>> includes;
  for (const SourceFile& file : all_files()) {
    for (const Include& include : includes_of(file))
      if (include.is_of_house) includes[file.path].push_back(include.path);
  }
  std::set<std::string> done, open;
  const std::function<void(const std::string&)> visit = [&](const std::string& path) {
    EXPECT_FALSE(open.contains(path)) << path << " includes itself by way of others";
    if (open.contains(path) || done.contains(path)) return;
    open.insert(path);
    for (const std::string& next : includes[path]) visit(next);
    open.erase(path);
    done.insert(path);
  };
  for (const SourceFile& file : all_files()) visit(file.path);
}

/// Libraries with a price, in compile time or in what they demand of a machine, are seen by few rooms.
TEST(HouseTest, LibrariesAreSeenWhereTheyBelong) {
  const std::map<std::string, std::vector<std::string>> homes{
      {"CGAL/", {"agents"}},
      {"CLI/", {"app/commands"}},
      {"GLFW/", {"app/viewer"}},
      {"gdal", {"maps"}},
      {"imgui.h", {"app/viewer"}},
      {"ogr", {"maps/georaster"}},
      {"OpenImageIO/", {"pictures", "maps"}},
      {"epoxy/", {"render", "bench"}},
      {"toml++/", {"world"}},
  };
  for (const SourceFile& file : all_files()) {
    if (file.is_test()) continue;
    for (const Include& include : includes_of(file)) {
      for (const auto& [library, folders] : homes) {
        if (include.is_of_house || !include.path.starts_with(library)) continue;
        EXPECT_TRUE(std::ranges::any_of(
            folders, [&](const auto& folder) { return file.path.starts_with(folder + "/"); }))
            << file.path << ':' << include.line << " includes " << include.path;
      }
    }
  }
}

TEST(HouseTest, RenderAndAppHaveFoldersOnly) {
  for (const SourceFile& file : all_files()) {
    for (const std::string room : {"render/", "app/"}) {
      EXPECT_FALSE(file.path.starts_with(room) && file.path.find('/', room.size()) == std::string::npos)
          << file.path << " lies in " << room << " itself";
    }
  }
}

TEST(HouseTest, FilesAndFunctionsAreSmall) {
  std::size_t functions = 0;
  for (const SourceFile& file : all_files()) {
    EXPECT_LE(file.lines.size(), kMostLinesOfFile) << file.path;
    for (const Function& function : functions_of(file)) {
      EXPECT_LE(function.lines, kMostLinesOfFunction) << file.path << ':' << function.line;
      ++functions;
    }
  }
  EXPECT_GT(functions, 3000u);
}

TEST(HouseTest, LinesFitIntoTheirColumns) {
  for (const SourceFile& file : all_files()) {
    for (std::size_t n = 0; n < file.lines.size(); ++n)
      EXPECT_LE(letters(file.lines[n]), kMostColumns) << file.path << ':' << n + 1;
  }
}

/// Binding points and uniforms' locations are told once, in shaders/shared/bindings.glsl, for both languages.
TEST(HouseTest, BindingNumbersOccurOnce) {
  const std::regex in_shaders(R"(binding\s*=\s*\d|layout\(location\s*=\s*\d+\)\s+uniform)");
  const std::regex in_code(R"(glBind(Textures|TextureUnit\(\s*\d|Buffer(Base|Range)\(\w+,\s*\d))"
                           R"(|glProgramUniform\w+\([^,]+,\s*\d)");
  for (const SourceFile& file : all_files()) {
    const bool draws_by_itself =
        file.path.starts_with("bench/scale_pl");  // a shader of its own, in the same file
    if (file.is_test() || draws_by_itself) continue;
    const std::vector<std::string> code = code_of(file);
    for (std::size_t n = 0; n < code.size(); ++n) {
      EXPECT_FALSE(std::regex_search(code[n], file.is_shader() ? in_shaders : in_code))
          << file.path << ':' << n + 1 << ": " << file.lines[n];
    }
  }
}

TEST(HouseTest, TextureUnitsAndBlocksAreDistinct) {
  const std::regex entry(R"(const int k(\w+)(Block|Buffer|Unit) = (\d+);)");
  std::map<std::string, std::set<int>> taken;
  std::size_t found = 0;
  for (const SourceFile& file : all_files()) {
    if (file.path != "shaders/shared/bindings.glsl") continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_search(line, match, entry)) continue;
      EXPECT_TRUE(taken[match[2]].insert(std::stoi(match[3])).second) << line << " is taken";
      ++found;
    }
  }
  EXPECT_GT(found, 20u);
  EXPECT_LE(taken["Buffer"].size(), 8u) << "OpenGL promises no more";
}

/// That the measuring of functions works.
TEST(SourceTreeTest, FunctionsAreFoundAndMeasured) {
  SourceFile file{"a.cpp",
                  {"namespace a {", "constexpr int kTable[] = {1, 2};", "int f(int x) {", "  if (x) {",
                   "    return '{';", "  }", "  return R\"({{)\"[0];  // {", "}", "class B {",
                   " public:", "  B() : x_{1} {}", "  template <class T>", "  void g(T t) const {",
                   "    t([&] { return 1; });", "  }", "};", "}  // namespace a"}};
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const Function& function : functions_of(file)) found.emplace_back(function.line, function.lines);
  EXPECT_EQ(found, (std::vector<std::pair<std::size_t, std::size_t>>{{3, 6}, {10, 2}, {12, 4}}));
}

}  // namespace
}  // namespace prairie
