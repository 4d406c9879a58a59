#include "render/gl/shader_program.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::string_view kInclude = "#include \"";
constexpr std::string_view kFolderName = "shaders/";

void append_source(const std::filesystem::path& folder, const std::string& name, std::set<std::string>& seen,
                   std::ostringstream& out) {
  if (!seen.insert(name).second) return;
  const std::filesystem::path path = folder / name;
  std::ifstream file(path);
  if (!file) throw BadInput(path.string(), "shader", "no readable file", "a file of the installation");
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with(kInclude)) {
      std::string included = line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
      if (included.starts_with(kFolderName)) included.erase(0, kFolderName.size());
      append_source(folder, included, seen, out);
    } else {
      out << line << '\n';
    }
  }
}

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
  std::replace_if(
      log.begin(), log.end(), [](char c) { return c == '\n' || c == '\0'; }, ' ');
  return log;
}

}  // namespace

std::string shader_source(const std::filesystem::path& folder, const std::string& name) {
  std::set<std::string> seen;
  std::ostringstream out;
  append_source(folder, name, seen, out);
  return out.str();
}

GlProgram make_program(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::vector<std::string>& defines) {
  GlProgram program(glCreateProgram());
  for (const std::string& name : names) {
    std::string source = shader_source(folder, name);
    for (const std::string& define : defines) {
      // The first line is #version, which must stay first.
      if (!define.empty()) source.insert(source.find('\n') + 1, "#define " + define + "\n");
    }
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(stage_of(name));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    const std::string log = compiled ? std::string() : info_log(shader, glGetShaderiv, glGetShaderInfoLog);
    glAttachShader(program.get(), shader);
    glDeleteShader(shader);
    if (!compiled)
      throw NoSuitableOpenGl((folder / name).string(), "compile", log, "a driver of OpenGL 4.5 core");
  }
  glLinkProgram(program.get());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (!linked) {
    throw NoSuitableOpenGl((folder / names.front()).string(), "link",
                           info_log(program.get(), glGetProgramiv, glGetProgramInfoLog),
                           "a driver of OpenGL 4.5 core");
  }
  return program;
}

}  // namespace prairie
