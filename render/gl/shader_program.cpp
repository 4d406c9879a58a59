#include "render/gl/shader_program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::string_view kInclude = "#include \"";
constexpr std::string_view kFolderName = "shaders/";
constexpr const char* kExpectedDriver = "a driver of OpenGL 4.5 core";

/// Puts files together, each once.
class SourceAssembly {
 public:
  SourceAssembly(const std::filesystem::path& folder, const std::vector<std::string>& defines)
      : folder_(folder), defines_(defines) {}

  void append(const std::string& name) {
    if (std::ranges::find(files_, name) != files_.end()) return;
    const std::size_t number = files_.size();
    files_.push_back(name);
    const std::filesystem::path path = folder_ / name;
    std::ifstream file(path);
    if (!file) throw BadInput(path.string(), "shader", "no readable file", "a file of the installation");
    if (number > 0) text_ << line_directive(1, number);
    std::string line;
    for (std::size_t next = 2; std::getline(file, line); ++next) {
      if (line.starts_with(kInclude)) {
        append(included_name(line));
        text_ << line_directive(next, number);
      } else {
        text_ << line << '\n';
      }
      if (number == 0 && next == 2) append_defines();  // after #version, which must stay first
    }
  }

  ShaderSource take() { return {text_.str(), std::move(files_)}; }

 private:
  static std::string line_directive(std::size_t line, std::size_t file) {
    return fmt::format("#line {} {}\n", line, file);
  }
  static std::string included_name(const std::string& line) {
    std::string name = line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
    if (name.starts_with(kFolderName)) name.erase(0, kFolderName.size());
    return name;
  }
  void append_defines() {
    for (const std::string& define : defines_) {
      if (!define.empty()) text_ << "#define " << define << '\n';
    }
    text_ << line_directive(2, 0);
  }

  const std::filesystem::path& folder_;
  const std::vector<std::string>& defines_;
  std::vector<std::string> files_;
  std::ostringstream text_;
};

GLenum stage_of(std::string_view name) {
  if (name.ends_with(".vert")) return GL_VERTEX_SHADER;
  if (name.ends_with(".frag")) return GL_FRAGMENT_SHADER;
  return GL_COMPUTE_SHADER;
}

std::string info_log(GLuint object, decltype(glGetShaderiv) get_parameter,
                     decltype(glGetShaderInfoLog) get_log) {
  GLint length = 0;
  get_parameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
  get_log(object, length, nullptr, log.data());
  log.resize(std::min(log.size(), log.find('\0')));
  return log;
}

std::string on_one_line(std::string log) {
  std::ranges::replace(log, '\n', ' ');
  return log;
}

/// Compiles a stage into the program.
void attach(GLuint program, const std::filesystem::path& folder, const std::string& name,
            const std::vector<std::string>& defines) {
  const ShaderSource source = shader_source(folder, name, defines);
  const char* text = source.text.c_str();
  const GLuint shader = glCreateShader(stage_of(name));
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = compiled ? std::string() : info_log(shader, glGetShaderiv, glGetShaderInfoLog);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  if (!compiled)
    throw NoSuitableOpenGl((folder / name).string(), "compile",
                           on_one_line(log_with_file_names(log, source.files)), kExpectedDriver);
}

}  // namespace

ShaderSource shader_source(const std::filesystem::path& folder, const std::string& name,
                           const std::vector<std::string>& defines) {
  SourceAssembly assembly(folder, defines);
  assembly.append(name);
  return assembly.take();
}

std::string log_with_file_names(const std::string& log, const std::vector<std::string>& files) {
  std::istringstream lines(log);
  std::string named, line;
  while (std::getline(lines, line)) {
    std::size_t number = 0;
    const char* end = line.data() + line.size();
    const auto parsed = std::from_chars(line.data(), end, number);
    const bool names_file = parsed.ec == std::errc() && parsed.ptr != end &&
                            (*parsed.ptr == ':' || *parsed.ptr == '(') && number < files.size();
    named += names_file ? files[number] + std::string(parsed.ptr, end) : line;
    named += '\n';
  }
  return named;
}

GlProgram make_program(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::vector<std::string>& defines) {
  GlProgram program(glCreateProgram());
  for (const std::string& name : names) attach(program.get(), folder, name, defines);
  glLinkProgram(program.get());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (!linked) {
    throw NoSuitableOpenGl((folder / names.front()).string(), "link",
                           on_one_line(info_log(program.get(), glGetProgramiv, glGetProgramInfoLog)),
                           kExpectedDriver);
  }
  const std::string label = fmt::format("{} {}", fmt::join(names, " "), fmt::join(defines, " "));
  glObjectLabel(GL_PROGRAM, program.get(), -1, label.c_str());
  return program;
}

}  // namespace prairie
